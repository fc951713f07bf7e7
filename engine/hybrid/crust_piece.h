// A piece of the crust near a hole: part of a closed oriented surface, with a border farther away.
//
// It may hold edges of four triangles, and parts of other sheets (the other side of a thin wall).
// Thread rule: values.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "spatial/point.h"

namespace stream_recon {

struct CrustPiece {
  std::vector<Point3> points;
  std::vector<std::array<std::uint32_t, 3>> triangles;  ///< counterclockwise from outside
};

}  // namespace stream_recon
