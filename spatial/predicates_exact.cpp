// How wide is wide enough: with L limbs a coordinate, as a multiple of the least unit among the
// points asked about, is below 2^(64 L - 3), so that a difference M is below 2^(64 L - 2). Then all
// intermediate results fit the limbs that determinants.h gives them:
//   cross_xy       2 M^2 < 2^(128 L - 3)
//   determinant3   6 M^3 < 2^(192 L - 3)
//   lift           3 M^2 + 2 weights of at most 2^(128 L - 6) each < 2^(128 L - 2)
//   lifted         4 * lift * 6 M^3 < 2^(320 L - 3); in the plane 3 * lift * 2 M^2 < 2^(256 L - 3)
#include "spatial/predicates_exact.h"

#include <cassert>

#include "spatial/coordinate_range.h"
#include "spatial/determinants.h"
#include "spatial/wide_integer.h"

namespace stream_recon::detail {
namespace {

template <int kLimbs>
struct Row {
  WideInteger<kLimbs> x;
  WideInteger<kLimbs> y;
  WideInteger<kLimbs> z;
};

// Differences of points in units, in `kLimbs` limbs a coordinate.
template <int kLimbs>
class Integers {
 public:
  explicit Integers(double per_unit) : per_unit_(per_unit) {}

  Row<kLimbs> difference(const Point3& a, const Point3& b) const {
    return {of(a.x) - of(b.x), of(a.y) - of(b.y), of(a.z) - of(b.z)};
  }
  WideInteger<2 * kLimbs> weight(const WeightedPoint3& p) const {
    return WideInteger<2 * kLimbs>::of(p.weight * per_unit_ * per_unit_);
  }

 private:
  WideInteger<kLimbs> of(double coordinate) const {
    return WideInteger<kLimbs>::of(coordinate * per_unit_);
  }

  double per_unit_;
};

// Calls compute(Integers) with as many limbs as the range of the points needs.
template <class Compute>
int with_enough_limbs(const CoordinateRange& range, const Compute& compute) {
  constexpr int kMostLimbs = 7;
  static_assert(CoordinateRange::kMostMagnitude - CoordinateRange::kLeastUnit <=
                64 * kMostLimbs - 3);
  assert(range.is_safe());
  if (range.empty()) return 0;
  const double per_unit = std::ldexp(1.0, -range.unit_exponent);
  const int places = range.magnitude_exponent - range.unit_exponent;
  if (places <= 64 - 3) return compute(Integers<1>(per_unit));
  if (places <= 128 - 3) return compute(Integers<2>(per_unit));
  return compute(Integers<kMostLimbs>(per_unit));
}

template <class... Points>
CoordinateRange range_of(const Points&... points) {
  CoordinateRange range;
  (range.extend(points), ...);
  return range;
}

}  // namespace

int exact_orient_xy(const Point3& a, const Point3& b, const Point3& c) {
  return with_enough_limbs(range_of(a, b, c), [&](const auto& integers) {
    return cross_xy(integers.difference(b, a), integers.difference(c, a)).sign();
  });
}

int exact_orient3d(const Point3& a, const Point3& b, const Point3& c, const Point3& d) {
  return with_enough_limbs(range_of(a, b, c, d), [&](const auto& integers) {
    return determinant3(integers.difference(b, a), integers.difference(c, a),
                        integers.difference(d, a))
        .sign();
  });
}

int exact_in_sphere(const std::array<Point3, 5>& p) {
  return with_enough_limbs(range_of(p[0], p[1], p[2], p[3], p[4]), [&](const auto& integers) {
    const auto a = integers.difference(p[0], p[4]);
    const auto b = integers.difference(p[1], p[4]);
    const auto c = integers.difference(p[2], p[4]);
    const auto d = integers.difference(p[3], p[4]);
    const Lifts lift{squared_length(a), squared_length(b), squared_length(c), squared_length(d)};
    return lifted_determinant(a, b, c, d, lift).sign();
  });
}

int exact_in_circle_xy(const std::array<Point3, 4>& p) {
  return with_enough_limbs(range_of(p[0], p[1], p[2], p[3]), [&](const auto& integers) {
    const auto a = integers.difference(p[0], p[3]);
    const auto b = integers.difference(p[1], p[3]);
    const auto c = integers.difference(p[2], p[3]);
    const Lifts lift{squared_length(a), squared_length(b), squared_length(c)};
    return lifted_determinant_xy(a, b, c, lift).sign();
  });
}

int exact_power_test(const std::array<WeightedPoint3, 5>& s) {
  return with_enough_limbs(range_of(s[0], s[1], s[2], s[3], s[4]), [&](const auto& integers) {
    const auto a = integers.difference(s[0].point, s[4].point);
    const auto b = integers.difference(s[1].point, s[4].point);
    const auto c = integers.difference(s[2].point, s[4].point);
    const auto d = integers.difference(s[3].point, s[4].point);
    const auto lift_of = [&](const auto& row, const WeightedPoint3& site) {
      return squared_length(row) + (integers.weight(s[4]) - integers.weight(site));
    };
    const Lifts lift{lift_of(a, s[0]), lift_of(b, s[1]), lift_of(c, s[2]), lift_of(d, s[3])};
    return lifted_determinant(a, b, c, d, lift).sign();
  });
}

int exact_power_circle_xy(const std::array<WeightedPoint3, 4>& s) {
  return with_enough_limbs(range_of(s[0], s[1], s[2], s[3]), [&](const auto& integers) {
    const auto a = integers.difference(s[0].point, s[3].point);
    const auto b = integers.difference(s[1].point, s[3].point);
    const auto c = integers.difference(s[2].point, s[3].point);
    const auto lift_of = [&](const auto& row, const WeightedPoint3& site) {
      return squared_length(row) + (integers.weight(s[3]) - integers.weight(site));
    };
    const Lifts lift{lift_of(a, s[0]), lift_of(b, s[1]), lift_of(c, s[2])};
    return lifted_determinant_xy(a, b, c, lift).sign();
  });
}

}  // namespace stream_recon::detail
