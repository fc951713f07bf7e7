#include "engine/windows/half_space.h"

#include <cmath>

#include "spatial/vector.h"

namespace stream_recon {
namespace {

constexpr double kRoundoff = 0x1p-53;
/// Of coordinates of points and bounds, relative to the reach.
constexpr double kBallError = 2e-14;

}  // namespace

HalfSpace::HalfSpace(const std::array<Point3, 3>& facet, const CloudIndex& index)
    : corner_(scaled(facet[0], index.scale)),
      corner_relative_(minus(corner_, index.origin)),
      reach_(index.reach) {
  const Point3 u = minus(scaled(facet[1], index.scale), corner_);
  const Point3 w = minus(scaled(facet[2], index.scale), corner_);
  normal_ = cross(u, w);
  normal_length_ = length(normal_);
  height_error_ = 16 * kRoundoff * (length(u) * length(w) + normal_length_);
  circle_ = FlatCircle::of({corner_, scaled(facet[1], index.scale), scaled(facet[2], index.scale)});
  if (circle_ && is_side_of(index.box)) {
    ball_ = circle_->ball();
    if (ball_) ball_->centre = minus(ball_->centre, index.origin);
  }
}

bool HalfSpace::is_beside_circle(const Point3& scaled_point) const {
  return circle_ && circle_->is_surely_outside(scaled_point);
}

/// Whether the plane is a side of the box, with nothing beyond.
bool HalfSpace::is_side_of(const Box3& box) const {
  const std::array<double, 3> low{box.low.x, box.low.y, box.low.z};
  const std::array<double, 3> high{box.high.x, box.high.y, box.high.z};
  const std::array<double, 3> normal{normal_.x, normal_.y, normal_.z};
  const auto axis = static_cast<std::size_t>(circle_->axis());
  return normal[axis] > 0 ? circle_->level() >= high[axis] : circle_->level() <= low[axis];
}

Region HalfSpace::at_least(double least, const ListFrame& frame) const {
  if (ball_) {
    const double radius = ball_->radius + kBallError * (ball_->radius + 4 * reach_);
    return ball_in(frame, ball_->centre, radius * radius);
  }
  // A normal of which nothing is known divides by 0: then the region is all of space.
  const double share = 1 / normal_length_;
  const Point3 unit = scaled(normal_, share);
  const double slack = 8 * reach_ * height_error_;
  return half_space_in(frame, unit, dot(unit, corner_relative_) + (least - slack) * share);
}

HalfSpace::Height HalfSpace::height(const Point3& scaled_point) const {
  const Point3 q = minus(scaled_point, corner_);
  return {dot(normal_, q), height_error_ * (std::abs(q.x) + std::abs(q.y) + std::abs(q.z))};
}

}  // namespace stream_recon
