#include "spatial/side_evidence.h"

#include <algorithm>
#include <cmath>

#include "spatial/vector.h"

namespace stream_recon {
namespace {

/// Windows and balls of so many spacings and more count in full. Chosen on known shapes, see
/// docs/decisions/0016-evidence.md and 0018-no-second-step.md.
constexpr double kFullWindow = 0.42;
constexpr double kFullBall = 1;

double share_of(double size, double full) {
  return size < full ? size / full : 1;
}

/// What speaks for it over what speaks against it, of a strength in [-1, 1] up to rounding. Tells
/// the surest evidence apart, where 1 + strength would leave a float no bits.
double odds(double strength) {
  if (std::isnan(strength)) return 1;
  constexpr double kLeast = 0x1p-50;
  return std::max(1 + strength, 0.0) / std::max(1 - strength, kLeast);
}

double square(const Point3& a) {
  return dot(a, a);
}

/// The smallest empty ball through the facet's corners, squared radius: their circle's, but where
/// both centres lie on one side of its plane the smaller ball's.
double squared_window(const FacetSides& balls, double smaller_ball) {
  const auto& [b, c] = balls.corners;
  const Point3 normal = cross(b, c);
  const bool is_one_sided = dot(normal, balls.centres[0]) * dot(normal, balls.centres[1]) > 0;
  if (is_one_sided) return smaller_ball;
  return square(b) * square(c) * square(minus(c, b)) / (4 * square(normal));
}

}  // namespace

// The balls meet at the angle at which the vectors from a corner to their centres stand, turned
// round; a half-space is a ball whose centre is infinitely far.
double same_side_evidence(const FacetSides& balls, double spacing) {
  const double first = square(balls.centres[0]);
  const double second = square(balls.centres[1]);
  const double cosine =
      -dot(balls.centres[0], balls.centres[1]) / (std::sqrt(first) * std::sqrt(second));
  const double smaller = balls.is_hull ? first : std::min(first, second);
  const double window = std::sqrt(squared_window(balls, smaller));
  return odds(-cosine * share_of(window, kFullWindow * spacing));
}

double opposite_evidence(const PoleBalls& poles, double spacing) {
  return odds(poles.cosine * share_of(poles.radius, kFullBall * spacing));
}

}  // namespace stream_recon
