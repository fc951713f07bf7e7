#include "spatial/flat_circle.h"

#include <cmath>

namespace stream_recon {
namespace {

/// Each term is a product of four differences, in eight roundings beside theirs, and there are
/// fewer than a dozen sums: 24 roundings at most.
constexpr double kError = 32 * 0x1p-53;
/// Beyond these products of four differences could be lost or infinite.
constexpr double kSmallest = 0x1p-900;
constexpr double kLargest = 0x1p1000;
/// Of the area that is not lost to cancelling, below which nothing is said of centre and radius.
constexpr double kLeastShare = 1e-6;
/// Of sides that are shorter squares could be lost.
constexpr double kSmallestArea = 0x1p-500;

struct Plane {
  double a, b;
};

double along(const Point3& p, int axis) {
  return axis == 0 ? p.x : axis == 1 ? p.y : p.z;
}

/// From one point to another, without the axis.
Plane difference(const Point3& to, const Point3& from, int axis) {
  const int first = axis == 0 ? 1 : 0;
  const int second = axis == 2 ? 1 : 2;
  return {along(to, first) - along(from, first), along(to, second) - along(from, second)};
}

double square(const Plane& v) {
  return v.a * v.a + v.b * v.b;
}

}  // namespace

std::optional<FlatCircle> FlatCircle::of(const std::array<Point3, 3>& corners) {
  for (int axis = 0; axis < 3; ++axis) {
    const double level = along(corners[0], axis);
    if (along(corners[1], axis) != level || along(corners[2], axis) != level) continue;
    FlatCircle circle;
    circle.axis_ = axis;
    circle.corner_ = corners[0];
    const Plane u = difference(corners[1], corners[0], axis);
    const Plane w = difference(corners[2], corners[0], axis);
    const double uu = square(u);
    const double ww = square(w);
    circle.area_ = u.a * w.b - u.b * w.a;
    circle.area_bound_ = std::abs(u.a * w.b) + std::abs(u.b * w.a);
    const bool is_known = std::abs(circle.area_) > kError * circle.area_bound_;
    if (!is_known || circle.area_bound_ < kSmallestArea) return std::nullopt;
    const double turn = circle.area_ > 0 ? 1 : -1;
    circle.area_ *= turn;
    circle.a_ = turn * (uu * w.b - ww * u.b);
    circle.b_ = turn * (ww * u.a - uu * w.a);
    circle.a_bound_ = uu * std::abs(w.b) + ww * std::abs(u.b);
    circle.b_bound_ = ww * std::abs(u.a) + uu * std::abs(w.a);
    return circle;
  }
  return std::nullopt;
}

double FlatCircle::level() const {
  return along(corner_, axis_);
}

std::optional<FlatCircle::Ball> FlatCircle::ball() const {
  if (!(area_ > kLeastShare * area_bound_)) return std::nullopt;
  const double a = a_ / (2 * area_);
  const double b = b_ / (2 * area_);
  const double radius = std::sqrt(a * a + b * b);
  const double error = 2 * kError * ((a_bound_ + b_bound_) / area_ + radius * area_bound_ / area_);
  Point3 centre = corner_;
  (axis_ == 0 ? centre.y : centre.x) += a;
  (axis_ == 2 ? centre.y : centre.z) += b;
  const double size = std::abs(centre.x) + std::abs(centre.y) + std::abs(centre.z);
  return Ball{centre, (radius + error + kError * size) * (1 + kError)};
}

bool FlatCircle::is_surely_outside(const Point3& point) const {
  if (along(point, axis_) != along(corner_, axis_)) return false;
  const Plane q = difference(point, corner_, axis_);
  const double qq = square(q);
  const double determinant = area_ * qq - a_ * q.a - b_ * q.b;
  const double bound = area_bound_ * qq + a_bound_ * std::abs(q.a) + b_bound_ * std::abs(q.b);
  return determinant > kError * bound && bound > kSmallest && bound < kLargest;
}

}  // namespace stream_recon
