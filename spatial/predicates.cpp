#include "spatial/predicates.h"

#include <cassert>
#include <cmath>

#include "spatial/power_filter.h"
#include "spatial/predicates_exact.h"

namespace stream_recon {
namespace {

// Largest differences, in units of the lattice, for which every intermediate result of the
// determinants in doubles is an integer of at most 2^53; compare predicates_exact.cpp.
constexpr double kOrientXyLimit = 0x1p26;     // 2 M^2
constexpr double kDeterminantLimit = 114503;  // 6 M^3
constexpr double kInCircleLimit = 4729;       // 18 M^4
constexpr double kInSphereLimit = 655;        // 72 M^5

// The point seen along another axis: 0 keeps it, 1 and 2 bring y z and z x in place of x y.
Point3 turned(const Point3& p, int axis) {
  if (axis == 1) return {p.y, p.z, p.x};
  if (axis == 2) return {p.z, p.x, p.y};
  return p;
}
WeightedPoint3 turned(const WeightedPoint3& p, int axis) {
  return {turned(p.point, axis), p.weight};
}

}  // namespace

Predicates::Predicates(const CoordinateRange& range) {
  assert(range.is_safe());
  const double unit = range.empty() ? 0 : std::ldexp(1.0, range.unit_exponent);
  orient_xy_reach_ = unit * kOrientXyLimit;
  determinant_reach_ = unit * kDeterminantLimit;
  in_circle_reach_ = unit * kInCircleLimit;
  in_sphere_reach_ = unit * kInSphereLimit;
}

int Predicates::orient3d_exact(const Point3& a, const Point3& b, const Point3& c,
                               const Point3& d) const {
  return detail::exact_orient3d(a, b, c, d);
}

int Predicates::in_sphere_exact(const Point3& a, const Point3& b, const Point3& c, const Point3& d,
                                const Point3& e) const {
  return detail::exact_in_sphere({a, b, c, d, e});
}

int Predicates::in_sphere_perturbed_exact(const Point3& a, const Point3& b, const Point3& c,
                                          const Point3& d, const Point3& e) const {
  const int sign = in_sphere_exact(a, b, c, d, e);
  return sign != 0 ? sign : decide_sphere_tie(a, b, c, d, e);
}

int Predicates::orient_xy(const Point3& a, const Point3& b, const Point3& c) const {
  const Estimate estimate = estimate_determinant_xy(difference(b, a), difference(c, a));
  if (estimate.is_certain() || estimate.reach <= orient_xy_reach_) return estimate.sign();
  return detail::exact_orient_xy(a, b, c);
}

int Predicates::coplanar_orientation(const Point3& a, const Point3& b, const Point3& c) const {
  for (int axis = 0; axis < 3; ++axis) {
    const int sign = orient_xy(turned(a, axis), turned(b, axis), turned(c, axis));
    if (sign != 0) return sign;
  }
  return 0;
}

// Relative to the orientation of a, b, c in x and y.
int Predicates::in_circle_xy(const Point3& a, const Point3& b, const Point3& c,
                             const Point3& d) const {
  const Estimate estimate =
      estimate_in_circle_xy(difference(a, d), difference(b, d), difference(c, d));
  if (estimate.is_certain() || estimate.reach <= in_circle_reach_) return estimate.sign();
  return detail::exact_in_circle_xy({a, b, c, d});
}

int Predicates::in_circle(const Point3& a, const Point3& b, const Point3& c,
                          const Point3& d) const {
  for (int axis = 0; axis < 3; ++axis) {
    const Point3 p = turned(a, axis);
    const Point3 q = turned(b, axis);
    const Point3 r = turned(c, axis);
    const int orientation = orient_xy(p, q, r);
    if (orientation != 0) return orientation * in_circle_xy(p, q, r, turned(d, axis));
  }
  assert(!"three collinear points have no circumcircle");
  return 0;
}

int Predicates::in_circle_perturbed(const Point3& a, const Point3& b, const Point3& c,
                                    const Point3& d) const {
  const int sign = in_circle(a, b, c, d);
  return sign != 0 ? sign : decide_circle_tie(a, b, c, d);
}

int Predicates::power_test(const WeightedPoint3& a, const WeightedPoint3& b,
                           const WeightedPoint3& c, const WeightedPoint3& d,
                           const WeightedPoint3& e) const {
  const PowerEstimate estimate = estimate_power_test(a, b, c, d, e);
  if (estimate.is_certain() || estimate.is_exact(in_sphere_reach_)) return estimate.sign();
  return detail::exact_power_test({a, b, c, d, e});
}

int Predicates::power_test_perturbed(const WeightedPoint3& a, const WeightedPoint3& b,
                                     const WeightedPoint3& c, const WeightedPoint3& d,
                                     const WeightedPoint3& e) const {
  const int sign = power_test(a, b, c, d, e);
  if (sign != 0) return sign;
  return decide_sphere_tie(a.point, b.point, c.point, d.point, e.point);
}

int Predicates::power_circle(const WeightedPoint3& a, const WeightedPoint3& b,
                             const WeightedPoint3& c, const WeightedPoint3& d) const {
  for (int axis = 0; axis < 3; ++axis) {
    const std::array<WeightedPoint3, 4> sites{turned(a, axis), turned(b, axis), turned(c, axis),
                                              turned(d, axis)};
    const int orientation = orient_xy(sites[0].point, sites[1].point, sites[2].point);
    if (orientation == 0) continue;
    const Estimate estimate = estimate_power_circle_xy(sites[0], sites[1], sites[2], sites[3]);
    if (estimate.is_certain()) return orientation * estimate.sign();
    return orientation * detail::exact_power_circle_xy(sites);
  }
  assert(!"three collinear sites have no orthogonal circle");
  return 0;
}

int Predicates::power_circle_perturbed(const WeightedPoint3& a, const WeightedPoint3& b,
                                       const WeightedPoint3& c, const WeightedPoint3& d) const {
  const int sign = power_circle(a, b, c, d);
  return sign != 0 ? sign : decide_circle_tie(a.point, b.point, c.point, d.point);
}

int Predicates::decide_sphere_tie(const Point3& a, const Point3& b, const Point3& c,
                                  const Point3& d, const Point3& query) const {
  return decide_tie<4>({&a, &b, &c, &d}, query, [this](const std::array<const Point3*, 4>& p) {
    return orient3d(*p[0], *p[1], *p[2], *p[3]);
  });
}

int Predicates::decide_circle_tie(const Point3& a, const Point3& b, const Point3& c,
                                  const Point3& query) const {
  const int orientation = coplanar_orientation(a, b, c);
  return decide_tie<3>({&a, &b, &c}, query, [&](const std::array<const Point3*, 3>& p) {
    return orientation * coplanar_orientation(*p[0], *p[1], *p[2]);
  });
}

}  // namespace stream_recon
