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
#include <cstddef>

#include "spatial/determinants.h"
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

/// The same for four corners as differences to the query, where all differences are multiples of
/// some unit and smaller than 1024 units, so that the determinants of doubles are exact. Then the
/// lexicographic order is that of a single number, and every coefficient is at hand: no branches.
inline int decide_lattice_tie(const Point3& a, const Point3& b, const Point3& c, const Point3& d) {
  // The query's own: position 0, coefficient -1.
  double largest_position = 0;
  double coefficient = -1;
  const auto consider = [&](const Point3& corner, double orientation) {
    const double position = (corner.x * 2048 + corner.y) * 2048 + corner.z;
    const bool decides = (position > largest_position) & (orientation != 0);
    largest_position = decides ? position : largest_position;
    coefficient = decides ? orientation : coefficient;
  };
  consider(a, detail::determinant3(b, c, d));
  consider(b, -detail::determinant3(a, c, d));
  consider(c, detail::determinant3(a, b, d));
  consider(d, -detail::determinant3(a, b, c));
  return coefficient > 0 ? 1 : -1;
}

}  // namespace stream_recon
