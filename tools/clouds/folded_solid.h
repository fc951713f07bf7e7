// A folded solid of large genus: one side of a gyroid, cut by a ball around the origin.
//
// The gyroid sin(kx)cos(ky) + sin(ky)cos(kz) + sin(kz)cos(kx) = 0 has three periods across the
// unit ball, k = 3 pi. Inside is where the sum is negative and the point is in the ball.
// Thread rule: stateless. Source: Schoen, NASA TN D-5541, 1970 (the gyroid).
#pragma once

#include <optional>

#include "spatial/point.h"
#include "tools/clouds/random.h"

namespace stream_recon {

/// Radians of the gyroid's waves per unit of length.
inline constexpr double kGyroidWave = 3 * 3.14159265358979323846;

/// The gyroid's value from the sines and cosines of kx, ky and kz: negative inside.
inline double gyroid_value(const Point3& sine, const Point3& cosine) {
  return sine.x * cosine.y + sine.y * cosine.z + sine.z * cosine.x;
}

struct GyroidField {
  double value;
  Point3 gradient;
};

/// \param wave radians a unit of length
GyroidField gyroid_field(const Point3& p, double wave = kGyroidWave);

/// A point on the surface of the solid in the ball of `radius`, the same density everywhere: each
/// call tries one candidate.
std::optional<Point3> try_folded_surface_point(Random& random, double radius);

}  // namespace stream_recon
