// A point of the cloud: three finite doubles, never moved or rounded.
#pragma once

#include <cmath>

namespace stream_recon {

struct Point3 {
  double x = 0;
  double y = 0;
  double z = 0;

  friend constexpr bool operator==(const Point3& a, const Point3& b) {
    return a.x == b.x && a.y == b.y && a.z == b.z;
  }
  /// Lexicographic order (x, y, z): the order of the symbolic perturbation
  /// (docs/algorithms/perturbation.md).
  friend constexpr bool operator<(const Point3& a, const Point3& b) {
    if (a.x != b.x) return a.x < b.x;
    if (a.y != b.y) return a.y < b.y;
    return a.z < b.z;
  }
};

/// A ball with squared radius `weight` (any sign), or a site of the power diagram.
struct WeightedPoint3 {
  Point3 point;
  double weight = 0;

  friend constexpr bool operator==(const WeightedPoint3& a, const WeightedPoint3& b) {
    return a.point == b.point && a.weight == b.weight;
  }
};

inline bool is_finite(const Point3& p) {
  return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
}

}  // namespace stream_recon
