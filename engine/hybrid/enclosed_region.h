// The triangles of the crust that walks enclose, at their left.
//
// The walks cut the crust into parts. A part is enclosed if it lies at the left of all walks beside
// it and does not reach the border of the crust's piece; one that lies at the right of all is
// outside; of any other the walks on its rarer side went astray, and if it lies mostly
// at the left and yet reaches the border, the piece has a gap there.
// Guarantees: without astray edges and gaps, the region as a chain has the walks as its boundary,
// exactly. Thread rule: pure. Memory: 8 bytes
// a triangle. Cost: linear.
#pragma once

#include <cstdint>
#include <vector>

#include "engine/hybrid/crust_mesh.h"

namespace stream_recon {

struct EnclosedRegion {
  std::vector<std::uint32_t> triangles;
  std::vector<std::uint32_t> astray;  ///< edges of the rings, some more than once
  std::vector<Point3> gaps;           ///< where an enclosed part ends
};

/// \param walked_for of each side: the edge of the rings, or kNoEdge
EnclosedRegion enclosed_region(const CrustMesh& crust,
                               const std::vector<std::uint32_t>& walked_for);

}  // namespace stream_recon
