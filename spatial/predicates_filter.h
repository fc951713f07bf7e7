// First rung of the predicates: determinants in doubles with a bound of their error.
//
// Guarantees: the exact determinant lies within `value` +- `error`, if the rows are differences of
// two doubles each, rounded once, and the coordinates are in the safe range of CoordinateRange
// (no overflow, no loss to underflow). Inline and free of branches: the kernel's inner loop.
// Source: Melquiond, Pion 2007 ("Formally certified floating-point filters for homogeneous
// geometric predicates"), with the error counted for the expressions in determinants.h.
//
// How the constants come about. With u = 2^-53 every rounding is a factor 1 + d, |d| <= u. Written
// out, a determinant is a sum of products, each with such a factor for every rounding it went
// through, those of its differences included; so the error is at most
//   (number of products) * (largest product) * ((1 + u)^roundings - 1).
// The largest product is bounded by X Y Z and the largest lift, where X, Y, Z are the largest
// differences per axis. Each constant is rounded up to cover u^2 terms and the rounding of the
// bound itself.
#pragma once

#include <algorithm>
#include <cmath>

#include "spatial/determinants.h"
#include "spatial/point.h"

namespace stream_recon {

/// An estimate of a determinant.
struct Estimate {
  double value;
  /// Bound of |value - exact determinant|.
  double error;
  /// The largest difference among the rows: decides whether the next rung applies.
  double reach;

  bool is_certain() const { return std::fabs(value) > error; }
  int sign() const { return (value > 0) - (value < 0); }
};

inline Point3 difference(const Point3& a, const Point3& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}

namespace detail {

inline constexpr double kRoundoff = 0x1p-53;
/// Error of estimate_in_sphere() over the product of the largest differences and the largest lift.
inline constexpr double kInSphereError = 390 * kRoundoff;

inline double largest(double a, double b, double c) {
  return std::max(std::max(std::fabs(a), std::fabs(b)), std::fabs(c));
}
inline double largest(double a, double b, double c, double d) {
  return std::max(std::max(std::fabs(a), std::fabs(b)), std::max(std::fabs(c), std::fabs(d)));
}

}  // namespace detail

/// |a b| in x and y. 2 products, each with 2 differences, 1 product, 1 sum: 2 * 4 u.
inline Estimate estimate_determinant_xy(const Point3& a, const Point3& b) {
  const double x = std::max(std::fabs(a.x), std::fabs(b.x));
  const double y = std::max(std::fabs(a.y), std::fabs(b.y));
  return {detail::cross_xy(a, b), 9 * detail::kRoundoff * (x * y), std::max(x, y)};
}

/// |a b c|. 6 products, each with 3 differences, 2 products, 3 sums: 6 * 8 u.
inline Estimate estimate_determinant(const Point3& a, const Point3& b, const Point3& c) {
  const double x = detail::largest(a.x, b.x, c.x);
  const double y = detail::largest(a.y, b.y, c.y);
  const double z = detail::largest(a.z, b.z, c.z);
  return {detail::determinant3(a, b, c), 49 * detail::kRoundoff * (x * y * z),
          std::max(std::max(x, y), z)};
}

/// Positive if the origin is inside the circumsphere of the positively oriented a, b, c, d.
/// 24 products with the lift: 3 + 2 differences, 2 + 1 + 1 products, 3 + 2 + 2 sums: 24 * 16 u.
inline Estimate estimate_in_sphere(const Point3& a, const Point3& b, const Point3& c,
                                   const Point3& d) {
  const detail::Lifts<double> lift{detail::squared_length(a), detail::squared_length(b),
                                   detail::squared_length(c), detail::squared_length(d)};
  const double x = detail::largest(a.x, b.x, c.x, d.x);
  const double y = detail::largest(a.y, b.y, c.y, d.y);
  const double z = detail::largest(a.z, b.z, c.z, d.z);
  const double top = std::max(std::max(lift.a, lift.b), std::max(lift.c, lift.d));
  return {detail::lifted_determinant(a, b, c, d, lift), detail::kInSphereError * (x * y * z * top),
          std::max(std::max(x, y), z)};
}

/// Positive if the origin is inside the circumcircle of a, b, c, all in one plane with it and
/// counterclockwise seen in x and y. 6 products: 2 + 2 differences, 1 + 1 + 1 products,
/// 1 + 2 + 2 sums: 6 * 12 u.
inline Estimate estimate_in_circle_xy(const Point3& a, const Point3& b, const Point3& c) {
  const detail::Lifts<double> lift{detail::squared_length(a), detail::squared_length(b),
                                   detail::squared_length(c), 0};
  const double x = detail::largest(a.x, b.x, c.x);
  const double y = detail::largest(a.y, b.y, c.y);
  const double z = detail::largest(a.z, b.z, c.z);
  const double top = detail::largest(lift.a, lift.b, lift.c);
  return {detail::lifted_determinant_xy(a, b, c, lift), 75 * detail::kRoundoff * (x * y * top),
          std::max(std::max(x, y), z)};
}

}  // namespace stream_recon
