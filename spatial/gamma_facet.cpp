#include "spatial/gamma_facet.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace stream_recon {
namespace {

/// The angle in terms of the heights over the facet's radius, f and s: with r^2 = 1 + f^2 each,
/// |x1 - x2|^2 - r1^2 - r2^2 = 2 (f s - 1), because the centres lie f + s apart on one line.
struct Angle {
  double numerator;  ///< cos delta times r1 r2
  double radii;      ///< r1 r2
  double scale;      ///< (r1^2 + r2^2) / 2, what ties are measured against
};

Angle angle_between(const FacetBalls& balls) {
  const double f = balls.height[0] / balls.radius;
  if (balls.height[1] == FacetBalls::kHalfSpace) {
    const double r = std::hypot(1.0, f);
    return {f, r, r};
  }
  const double s = balls.height[1] / balls.radius;
  return {f * s - 1, std::hypot(1.0, f) * std::hypot(1.0, s), 1 + (f * f + s * s) / 2};
}

/// The height over the facet's radius at which the ball meets the hull's half-space at an angle of
/// this cosine.
double height_at_hull(double cosine) {
  constexpr double kNever = std::numeric_limits<double>::infinity();
  if (std::abs(cosine) >= 1) return std::copysign(kNever, cosine);
  return cosine / std::sqrt((1 - cosine) * (1 + cosine));
}

}  // namespace

// Through the sine so that 90 degrees is exactly zero. An estimate is off by an error that moves
// the cosine at the hull by less than two of it; one more is for the margin and rounding.
GammaCriterion::GammaCriterion(double delta_max_degrees)
    : cosine_(std::sin((90 - delta_max_degrees) * std::numbers::pi / 180)),
      hull_out_below_(height_at_hull(cosine_ - 3 * BallEstimate::kError)),
      hull_in_above_(height_at_hull(cosine_ + 3 * BallEstimate::kError)) {}

bool GammaCriterion::takes(const FacetBalls& balls) const {
  const Angle angle = angle_between(balls);
  return angle.numerator - cosine_ * angle.radii > kMargin * angle.scale;
}

double gamma_angle(const FacetBalls& balls) {
  const Angle angle = angle_between(balls);
  const double cosine = std::clamp(angle.numerator / angle.radii, -1.0, 1.0);
  return std::acos(cosine) * 180 / std::numbers::pi;
}

}  // namespace stream_recon
