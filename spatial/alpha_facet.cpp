#include "spatial/alpha_facet.h"

#include <algorithm>
#include <cmath>

namespace stream_recon {
namespace {

constexpr double kMargin = 1e-9;

/// Covers the estimates of radii and what is computed of them, kMargin included.
constexpr double kSlack = 8 * BallEstimate::kError;

enum class Size { kSmaller, kLarger, kUnknown };

/// An estimated radius, or the facet's own, against alpha.
Size compare(double radius, double alpha) {
  if (radius < alpha * (1 - kSlack)) return Size::kSmaller;
  return radius > alpha * (1 + kSlack) ? Size::kLarger : Size::kUnknown;
}

/// The sign of an estimated height, 0 where it is not sure.
int sign(double height) {
  if (height == BallEstimate::kHalfSpace) return 1;
  const double error = 2 * BallEstimate::kError * std::sqrt(1 + height * height);
  if (height > error) return 1;
  return height < -error ? -1 : 0;
}

double facet_radius(const BallEstimate& ball) {
  return ball.radius / std::sqrt(1 + ball.height * ball.height);
}

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

Verdict AlphaCriterion::judge(const BallEstimate& one, const BallEstimate& two) const {
  const Size first = compare(one.radius, alpha_);
  const Size second = compare(two.radius, alpha_);
  if (first == Size::kUnknown || second == Size::kUnknown) return Verdict::kUnsure;
  if (first == Size::kSmaller && second == Size::kSmaller) return Verdict::kOut;
  if (first != second) return Verdict::kIn;
  // Both are larger: the interval of radii reaches below the smaller one at a Gabriel facet only.
  const int sign_one = sign(one.height);
  const int sign_two = sign(two.height);
  if (sign_one < 0 || sign_two < 0) return Verdict::kOut;
  if (sign_one == 0 || sign_two == 0) return Verdict::kUnsure;
  const Size own =
      compare(facet_radius(one.height == BallEstimate::kHalfSpace ? two : one), alpha_);
  if (own == Size::kUnknown) return Verdict::kUnsure;
  return own == Size::kLarger ? Verdict::kOut : Verdict::kIn;
}

}  // namespace stream_recon
