#include "spatial/side_evidence.h"

#include <algorithm>
#include <cmath>

namespace stream_recon {
namespace {

/// Windows and balls of so many spacings and more count in full. Chosen on known shapes, see
/// docs/decisions/0016-evidence.md and 0018-no-second-step.md.
constexpr double kFullWindow = 0.42;
constexpr double kFullBall = 1;

double share_of(double size, double full) {
  return size < full ? size / full : 1;
}

/// 1 + strength, within the promised range whatever rounding did.
double weight(double strength) {
  return std::clamp(1 + strength, 0.0, 2.0);
}

double slant(double height) {
  return std::sqrt(1 + height * height);
}

}  // namespace

// In terms of the heights over the facet's radius, f and s, the cosine of the angle at which the
// balls meet is (f s - 1) / (sqrt(1 + f^2) sqrt(1 + s^2)), at the hull f / sqrt(1 + f^2). The
// window is the smallest empty ball through the facet's corners.
double same_side_evidence(const FacetBalls& balls, double spacing) {
  const double f = balls.height[0] / balls.radius;
  const bool is_hull = balls.height[1] == FacetBalls::kHalfSpace;
  const double s = is_hull ? 0 : balls.height[1] / balls.radius;
  const double cosine = is_hull ? f / slant(f) : (f * s - 1) / (slant(f) * slant(s));
  const double beyond = std::min(std::min(f, s), 0.0);
  const double window = balls.radius * slant(beyond);
  return weight(-cosine * share_of(window, kFullWindow * spacing));
}

double opposite_evidence(const PoleBalls& poles, double spacing) {
  return weight(poles.cosine * share_of(poles.radius, kFullBall * spacing));
}

}  // namespace stream_recon
