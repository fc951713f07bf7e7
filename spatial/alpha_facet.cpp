#include "spatial/alpha_facet.h"

#include <algorithm>
#include <cmath>

namespace stream_recon {
namespace {

constexpr double kMargin = 1e-9;

}  // namespace

RadiusInterval empty_ball_radii(const FacetBalls& balls) {
  const double first = std::hypot(balls.radius, balls.height[0]);
  const double second = std::hypot(balls.radius, balls.height[1]);
  const bool gabriel = balls.height[0] >= 0 && balls.height[1] >= 0;
  return {gabriel ? balls.radius : std::min(first, second), std::max(first, second)};
}

bool is_alpha_facet(const FacetBalls& balls, double alpha) {
  const RadiusInterval radii = empty_ball_radii(balls);
  return radii.smallest <= alpha * (1 + kMargin) && radii.largest >= alpha * (1 - kMargin);
}

}  // namespace stream_recon
