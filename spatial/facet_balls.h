// The two empty balls that touch a Delaunay facet: one through its three points and the apex on
// either side, described where the facet sees them.
//
// Guarantees: heights are exact to 1e-10 of the ball's radius however flat the tetrahedron
// is, and are functions of the five points alone: give the facet in a canonical order (by rank) and
// the bits do not depend on the window that asks. Thread rule: pure functions. Cost: about 120
// flops; flat tetrahedra (5 in 100 on scanned surfaces) need more bits and ten times as long.
#pragma once

#include <array>
#include <limits>

#include "spatial/point.h"

namespace stream_recon {

struct FacetBalls {
  /// Circumradius of the facet in its own plane, units of the input.
  double radius = 0;
  /// Distance of each ball's centre from the facet's plane, units of the input; positive on the
  /// side of the ball's own apex. A ball has radius hypot(radius, height). Infinite for the
  /// half-space beyond a hull facet. At a Delaunay facet height[0] + height[1] >= 0.
  std::array<double, 2> height{};

  static constexpr double kHalfSpace = std::numeric_limits<double>::infinity();
};

/// \pre Neither apex lies in the plane of the facet.
FacetBalls facet_balls(const std::array<Point3, 3>& facet, const Point3& apex_one,
                       const Point3& apex_two);

/// The same at the convex hull: the second ball is the half-space beyond.
FacetBalls hull_facet_balls(const std::array<Point3, 3>& facet, const Point3& apex);

}  // namespace stream_recon
