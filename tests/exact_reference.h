// Reference predicates in integers of unlimited size: slow, obvious, exact.
#pragma once

#include <array>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>

#include "spatial/point.h"

namespace stream_recon::reference {

using Integer = boost::multiprecision::cpp_int;
using Vector = std::array<Integer, 3>;

// value * 2^shift; every test coordinate is a multiple of 2^-shift.
inline Integer to_integer(double value, int shift) {
  int exponent = 0;
  const double mantissa = std::frexp(value, &exponent);
  Integer integer = static_cast<std::int64_t>(std::ldexp(mantissa, 53));
  const int places = exponent - 53 + shift;
  if (places >= 0) return integer << places;
  // Exact: the test coordinates have no bits below.
  return integer / (Integer(1) << -places);
}

inline constexpr int kShift = 300;

inline Vector to_vector(const Point3& p) {
  return {to_integer(p.x, kShift), to_integer(p.y, kShift), to_integer(p.z, kShift)};
}

inline Vector minus(const Vector& a, const Vector& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

inline Integer dot(const Vector& a, const Vector& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

inline Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

inline Integer determinant(const Vector& a, const Vector& b, const Vector& c) {
  return dot(a, cross(b, c));
}

inline int orient3d(const Point3& a, const Point3& b, const Point3& c, const Point3& d) {
  const Vector p = to_vector(a);
  return determinant(minus(to_vector(b), p), minus(to_vector(c), p), minus(to_vector(d), p)).sign();
}

// Laplace expansion of the determinant of rows (x, y, z, |.|^2 - w), negated.
inline int power_test(const std::array<WeightedPoint3, 5>& sites) {
  const Vector origin = to_vector(sites[4].point);
  std::array<Vector, 4> row;
  std::array<Integer, 4> lift;
  for (int i = 0; i < 4; ++i) {
    row[i] = minus(to_vector(sites[i].point), origin);
    lift[i] = dot(row[i], row[i]) - to_integer(sites[i].weight, 2 * kShift) +
              to_integer(sites[4].weight, 2 * kShift);
  }
  const Integer sum = lift[0] * determinant(row[1], row[2], row[3]) -
                      lift[1] * determinant(row[0], row[2], row[3]) +
                      lift[2] * determinant(row[0], row[1], row[3]) -
                      lift[3] * determinant(row[0], row[1], row[2]);
  return sum.sign();
}

inline int in_sphere(const Point3& a, const Point3& b, const Point3& c, const Point3& d,
                     const Point3& e) {
  return power_test({{{a, 0}, {b, 0}, {c, 0}, {d, 0}, {e, 0}}});
}

// The sphere test of a, b, c and a fourth site off their plane: a + normal, on the sphere through
// a, b, c of any centre; expanded, only the component along the normal is left.
inline int power_circle(const std::array<WeightedPoint3, 4>& sites) {
  const Vector origin = to_vector(sites[3].point);
  std::array<Vector, 3> row;
  std::array<Integer, 3> lift;
  for (int i = 0; i < 3; ++i) {
    row[i] = minus(to_vector(sites[i].point), origin);
    lift[i] = dot(row[i], row[i]) - to_integer(sites[i].weight, 2 * kShift) +
              to_integer(sites[3].weight, 2 * kShift);
  }
  const Vector normal = cross(minus(row[1], row[0]), minus(row[2], row[0]));
  const Integer sum = lift[0] * dot(normal, cross(row[1], row[2])) +
                      lift[1] * dot(normal, cross(row[2], row[0])) +
                      lift[2] * dot(normal, cross(row[0], row[1]));
  return sum.sign();
}

}  // namespace stream_recon::reference
