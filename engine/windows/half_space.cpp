#include "engine/windows/half_space.h"

#include <cmath>

#include "spatial/vector.h"

namespace stream_recon {
namespace {

constexpr double kRoundoff = 0x1p-53;

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
}

bool HalfSpace::is_beside_circle(const Point3& scaled_point) const {
  return circle_ && circle_->is_surely_outside(scaled_point);
}

Region HalfSpace::at_least(double least, const ListFrame& frame) const {
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
