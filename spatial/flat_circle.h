// The circumcircle of a triangle in a plane square to an axis, for points in that plane.
//
// Guarantees: is_surely_outside() is never wrong: the three corners and the point have one
// coordinate in common, bit for bit, and the sign of the incircle determinant is beyond its
// rounding. Thread rule: a value. Memory: 80 bytes. Cost: 3 ns. Source: Shewchuk, Adaptive
// precision floating-point arithmetic and fast robust geometric predicates, 1997, section 3 (error
// bounds of static filters).
#pragma once

#include <array>
#include <optional>

#include "spatial/point.h"

namespace stream_recon {

class FlatCircle {
 public:
  /// Nothing if the corners have no coordinate in common, or are on a line for all that doubles
  /// tell.
  static std::optional<FlatCircle> of(const std::array<Point3, 3>& corners);

  bool is_surely_outside(const Point3& point) const;

  /// Of the axis: 0, 1 or 2.
  int axis() const { return axis_; }
  /// That the plane is at.
  double level() const;

  struct Ball {
    Point3 centre;
    double radius;  ///< its rounding and the centre's allowed for
  };
  /// Holds all points of the plane on the circle or inside; nothing if doubles know it badly.
  std::optional<Ball> ball() const;

 private:
  int axis_ = 0;
  Point3 corner_;
  // The determinant of a point at q from the corner is area q.q - a q_a - b q_b, turned so that it
  // is positive outside.
  double area_ = 0, a_ = 0, b_ = 0;
  double area_bound_ = 0, a_bound_ = 0, b_bound_ = 0;  ///< the same, of absolute values
};

}  // namespace stream_recon
