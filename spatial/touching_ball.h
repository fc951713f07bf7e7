// The ball through four points, as a result: centre and radius rounded from wider arithmetic.
//
// Guarantees: a function of the four points, given in one order (by rank), bit for bit. Radius and
// distance of the centre are right to 2^-50 of the radius, each coordinate of the centre besides to
// half its last place. Flat tetrahedra are computed exactly. Tetrahedra of one ball, as those of
// lattices, get the same bits, unless a coordinate lies within 2^-80 of the radius of the middle
// between two doubles. Thread rule: pure. Cost: 1 us; slivers 5 us, the flattest 200 us.
#pragma once

#include <array>
#include <cmath>

#include "spatial/point.h"

namespace stream_recon {

struct TouchingBall {
  Point3 centre;
  double radius = 0;
  /// The largest angle at the centre between two of the points, degrees, (0, 180].
  float separation = 0;

  /// False where the ball is too large for doubles.
  bool is_finite() const {
    return std::isfinite(centre.x) && std::isfinite(centre.y) && std::isfinite(centre.z) &&
           std::isfinite(radius);
  }
};

/// \pre not coplanar; coordinates of a CoordinateRange that has a scale()
TouchingBall touching_ball(const std::array<Point3, 4>& tetrahedron);

}  // namespace stream_recon
