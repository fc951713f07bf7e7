// The symbolic perturbation that decides cospherical points.
//
// Every point q is lifted by an infinitesimal amount; the amounts fall steeply with the place of q
// in the lexicographic (x, y, z) order, the largest point having by far the largest. An in-sphere
// determinant that is zero then has the sign of the first nonzero coefficient of these amounts,
// from the largest point downwards. The coefficient of a corner is the orientation of the simplex
// with the query in that corner's place; that of the query is minus the orientation of the simplex.
// So the answer depends on the points alone, is never zero, and leaves no flat simplices.
// Source: Devillers, Teillaud 2011 ("Perturbations for Delaunay and weighted Delaunay 3D
// triangulations", section 3).
#pragma once

#include <array>

#include "spatial/point.h"

namespace stream_recon {

/// The sign of a vanishing in-sphere (in-circle) test for the positively oriented simplex
/// `corners`: +1 where the query is inside the perturbed circumsphere, -1 outside. \param
/// orientation gives the sign of a simplex whose corners are passed as such an array. \pre The
/// query is none of the corners.
template <std::size_t kCorners, class Orientation>
int decide_tie(const std::array<const Point3*, kCorners>& corners, const Point3& query,
               const Orientation& orientation) {
  std::array<bool, kCorners> passed{};
  for (;;) {
    const Point3* top = &query;
    std::size_t top_corner = kCorners;
    for (std::size_t i = 0; i < kCorners; ++i) {
      if (!passed[i] && *top < *corners[i]) {
        top = corners[i];
        top_corner = i;
      }
    }
    if (top_corner == kCorners) return -1;
    std::array<const Point3*, kCorners> replaced = corners;
    replaced[top_corner] = &query;
    if (const int sign = orientation(replaced); sign != 0) return sign;
    passed[top_corner] = true;
  }
}

}  // namespace stream_recon
