// The geometric predicates: exact signs at nearly the price of floating point.
//
// Guarantees: every answer is the sign of the exact determinant, if the coordinates are in the
// safe range of CoordinateRange. The perturbed tests are never 0 and depend on the points alone.
// A ladder of rungs: a determinant in doubles with an error bound (predicates_filter.h); where the
// cloud lies on a lattice of spacing 2^k and the points are close together, the same determinant
// is known to be exact, zeros included; wide integers (predicates_exact.h).
// Thread rule: const and shared. Cost: 10 to 20 ns, on a lattice too.
// Sources: Melquiond, Pion 2007; Devillers, Teillaud 2011.
#pragma once

#include "spatial/coordinate_range.h"
#include "spatial/perturbation.h"
#include "spatial/point.h"
#include "spatial/predicates_filter.h"

namespace stream_recon {

class Predicates {
 public:
  /// \param range holds all coordinates that will be asked about. \pre range.is_safe()
  explicit Predicates(const CoordinateRange& range);

  /// +1 if a, b, c are counterclockwise seen from d: the sign of |b - a, c - a, d - a|.
  int orient3d(const Point3& a, const Point3& b, const Point3& c, const Point3& d) const {
    const Point3 u = difference(b, a);
    const Point3 v = difference(c, a);
    const Point3 w = difference(d, a);
    const Estimate estimate = estimate_determinant(u, v, w);
    if (estimate.is_certain() || estimate.reach <= determinant_reach_) return estimate.sign();
    return orient3d_exact(a, b, c, d);
  }

  /// +1 if e is inside the circumsphere of the positively oriented a, b, c, d, 0 if on it.
  int in_sphere(const Point3& a, const Point3& b, const Point3& c, const Point3& d,
                const Point3& e) const {
    const Estimate estimate =
        estimate_in_sphere(difference(a, e), difference(b, e), difference(c, e), difference(d, e));
    if (estimate.is_certain() || estimate.reach <= in_sphere_reach_) return estimate.sign();
    return in_sphere_exact(a, b, c, d, e);
  }

  /// The same with ties decided (perturbation.h): never 0.
  int in_sphere_perturbed(const Point3& a, const Point3& b, const Point3& c, const Point3& d,
                          const Point3& e) const {
    const Point3 ae = difference(a, e);
    const Point3 be = difference(b, e);
    const Point3 ce = difference(c, e);
    const Point3 de = difference(d, e);
    const Estimate estimate = estimate_in_sphere(ae, be, ce, de);
    if (estimate.is_certain()) return estimate.sign();
    if (estimate.reach > in_sphere_reach_) return in_sphere_perturbed_exact(a, b, c, d, e);
    return estimate.value != 0 ? estimate.sign() : decide_lattice_tie(ae, be, ce, de);
  }

  /// What in_sphere_perturbed() says where in_sphere() is known to be 0.
  /// \pre The points differ by no more than in_sphere_reach() in any coordinate.
  int in_sphere_tie(const Point3& a, const Point3& b, const Point3& c, const Point3& d,
                    const Point3& e) const {
    return decide_lattice_tie(difference(a, e), difference(b, e), difference(c, e),
                              difference(d, e));
  }

  /// Coordinate differences up to this make an in-sphere determinant of doubles exact.
  double in_sphere_reach() const { return in_sphere_reach_; }

  /// Orientation of three points in space as seen along the first of the axes z, y, x along which
  /// they are not collinear; 0 if they are collinear. Comparable for points of one plane.
  int coplanar_orientation(const Point3& a, const Point3& b, const Point3& c) const;

  /// +1 if d is inside the circumcircle of a, b, c (in any orientation), 0 if on it.
  /// \pre The four points are coplanar, the first three not collinear.
  int in_circle(const Point3& a, const Point3& b, const Point3& c, const Point3& d) const;
  int in_circle_perturbed(const Point3& a, const Point3& b, const Point3& c, const Point3& d) const;

  /// +1 if e is closer than orthogonal to the sphere orthogonal to the positively oriented a, b, c,
  /// d: |e - z|^2 - w_e - w_z < 0 for its centre z and weight w_z. 0 if orthogonal.
  int power_test(const WeightedPoint3& a, const WeightedPoint3& b, const WeightedPoint3& c,
                 const WeightedPoint3& d, const WeightedPoint3& e) const;
  int power_test_perturbed(const WeightedPoint3& a, const WeightedPoint3& b,
                           const WeightedPoint3& c, const WeightedPoint3& d,
                           const WeightedPoint3& e) const;

  /// The power test in the plane of four coplanar sites, under the preconditions of in_circle().
  int power_circle(const WeightedPoint3& a, const WeightedPoint3& b, const WeightedPoint3& c,
                   const WeightedPoint3& d) const;
  int power_circle_perturbed(const WeightedPoint3& a, const WeightedPoint3& b,
                             const WeightedPoint3& c, const WeightedPoint3& d) const;

 private:
  int orient3d_exact(const Point3& a, const Point3& b, const Point3& c, const Point3& d) const;
  int in_sphere_exact(const Point3& a, const Point3& b, const Point3& c, const Point3& d,
                      const Point3& e) const;
  int in_sphere_perturbed_exact(const Point3& a, const Point3& b, const Point3& c, const Point3& d,
                                const Point3& e) const;
  int orient_xy(const Point3& a, const Point3& b, const Point3& c) const;
  int in_circle_xy(const Point3& a, const Point3& b, const Point3& c, const Point3& d) const;
  int decide_sphere_tie(const Point3& a, const Point3& b, const Point3& c, const Point3& d,
                        const Point3& query) const;
  int decide_circle_tie(const Point3& a, const Point3& b, const Point3& c,
                        const Point3& query) const;

  // Differences up to these make the determinants of doubles exact; 0 without a lattice.
  double orient_xy_reach_;
  double determinant_reach_;
  double in_circle_reach_;
  double in_sphere_reach_;
};

}  // namespace stream_recon
