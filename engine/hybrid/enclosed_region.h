// The triangles of the crust that walks enclose, at their left.
//
// The walks cut the crust into parts. A part is enclosed if it lies at the left of all walks beside
// it and does not reach the border of the crust's piece; one that lies at the right of all is
// outside; of any other the walks on its rarer side went astray. Guarantees: without astray edges,
// the region as a chain has the walks as its boundary, exactly. Thread rule: pure. Memory: 8 bytes
// a triangle. Cost: linear.
#pragma once

#include <cstdint>
#include <vector>

#include "engine/hybrid/crust_mesh.h"

namespace stream_recon {

struct EnclosedRegion {
  std::vector<std::uint32_t> triangles;
  std::vector<std::uint32_t> astray;  ///< edges of the rings, some more than once
};

/// \param walked_for of each side: the edge of the rings, or kNoEdge
EnclosedRegion enclosed_region(const CrustMesh& crust,
                               const std::vector<std::uint32_t>& walked_for);

}  // namespace stream_recon
