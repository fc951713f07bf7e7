// A hole of the gamma shape: triangles of the solid that hang together at edges and are no gamma
// facets.
//
// Thread rule: values.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "spatial/point.h"

namespace stream_recon {

using HoleEdge = std::array<std::uint32_t, 2>;      ///< from, to
using HoleTriangle = std::array<std::uint32_t, 3>;  ///< counterclockwise from outside

/// Local numbers: positions in `points`.
struct Hole {
  std::vector<Point3> points;  ///< samples: all corners of the fills, in the order of their ranks
  std::vector<HoleTriangle> fills;  ///< the solid's triangles in the hole
  /// Edges between its points of facets outside the hole, from the lower corner, and those facets
  /// all of whose corners are its points, ascending: a patch must not have them as well.
  std::vector<HoleEdge> outer_edges;
  std::vector<HoleTriangle> outer_facets;
};

}  // namespace stream_recon
