// The triangles of the crust that walks enclose, at their left.
//
// The walks cut the crust into parts. A part is enclosed if it lies at the left of all walks beside
// it and does not reach the border of the crust's piece. If a part lies at the left of some but
// also at the right of others or at the border, inside and outside leak into each other: by a
// tunnel or a gap of the crust, or by a small ring that the walks turn over. The share of the way
// from inside to outside at which the fewest sides lie across is the leak. Guarantees: without
// leaks the region as a chain has the walks as its boundary, exactly. Thread rule: pure. Memory: 17
// bytes a triangle. Cost: linear; n log n for leaks.
#pragma once

#include <cstdint>
#include <vector>

#include "engine/hybrid/crust_mesh.h"

namespace stream_recon {

struct EnclosedRegion {
  std::vector<std::uint32_t> triangles;
  std::vector<std::uint32_t> leaks;  ///< vertices of the crust, some more than once
};

/// \param walked_for of each side: the edge of the rings, or kNoEdge
EnclosedRegion enclosed_region(const CrustMesh& crust,
                               const std::vector<std::uint32_t>& walked_for);

}  // namespace stream_recon
