// Vectors as points: the few operations of geometry in doubles.
#pragma once

#include <cmath>

#include "spatial/point.h"

namespace stream_recon {

constexpr Point3 minus(const Point3& a, const Point3& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
constexpr Point3 plus(const Point3& a, const Point3& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
constexpr Point3 scaled(const Point3& a, double by) {
  return {a.x * by, a.y * by, a.z * by};
}
constexpr double dot(const Point3& a, const Point3& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
constexpr Point3 cross(const Point3& a, const Point3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline double length(const Point3& a) {
  return std::sqrt(dot(a, a));
}

}  // namespace stream_recon
