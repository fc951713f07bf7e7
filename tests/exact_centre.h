// Circumcentres in rational numbers: what the balls of tetrahedra are compared with.
#pragma once

#include <array>
#include <boost/multiprecision/cpp_int.hpp>
#include <optional>

#include "spatial/point.h"

namespace stream_recon {

using Rational = boost::multiprecision::cpp_rational;
using Vector = std::array<Rational, 3>;
using Corners = std::array<Point3, 4>;

inline Vector vector_to(const Point3& p, const Point3& origin) {
  return {Rational(p.x) - Rational(origin.x), Rational(p.y) - Rational(origin.y),
          Rational(p.z) - Rational(origin.z)};
}

inline Rational dot(const Vector& a, const Vector& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

inline Rational determinant(const std::array<Vector, 3>& m) {
  const auto& [a, b, c] = m;
  return a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) +
         a[2] * (b[0] * c[1] - b[1] * c[0]);
}

/// Relative to the first corner, by Cramer's rule on 2 p.x = |p|^2; nothing if coplanar.
inline std::optional<Vector> exact_centre(const Corners& corners) {
  const std::array<Vector, 3> rows{vector_to(corners[1], corners[0]),
                                   vector_to(corners[2], corners[0]),
                                   vector_to(corners[3], corners[0])};
  const Rational all = determinant(rows);
  if (all == 0) return std::nullopt;
  Vector centre;
  for (int axis = 0; axis < 3; ++axis) {
    auto replaced = rows;
    for (int row = 0; row < 3; ++row) replaced[row][axis] = dot(rows[row], rows[row]) / 2;
    centre[axis] = determinant(replaced) / all;
  }
  return centre;
}

}  // namespace stream_recon
