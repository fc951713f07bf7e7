// Random points on smooth surfaces of known shape, the same density everywhere.
//
// Each call tries one candidate and keeps it with a probability proportional to the surface's area
// there, so that callers repeat until they have a point. Thread rule: one user a generator.
#pragma once

#include <optional>

#include "spatial/point.h"
#include "tools/clouds/random.h"

namespace stream_recon {

/// The ellipsoid with half axes 1, 0.7 and 0.5.
std::optional<Point3> try_ellipsoid_point(Random& random);

/// The blob, a ball of radius 1 with smooth bumps of up to 0.2, in the direction u of length 1:
/// r(u) = 1 + a sum of sine waves in u.
struct BlobRadius {
  double value;
  Point3 gradient;  ///< of the sum as a function of space
};
BlobRadius blob_radius(const Point3& u);

/// The blob.
std::optional<Point3> try_blob_point(Random& random);

/// The torus with radii 1 and 0.4 around the z axis.
std::optional<Point3> try_torus_point(Random& random);

}  // namespace stream_recon
