// The triangles of the crust that walks enclose, at their left.
//
// Guarantees: taken as a chain, the boundary of the region is the walks, exactly; it does not touch
// the border of the crust's piece. Thread rule: pure. Memory: 1 bit a triangle, 4 bytes one of the
// region. Cost: linear in the region.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "engine/hybrid/crust_mesh.h"

namespace stream_recon {

/// \param is_walked of each side
/// \return triangles, ascending; nothing if what is at the left reaches the border or the right
std::optional<std::vector<std::uint32_t>> enclosed_region(const CrustMesh& crust,
                                                          const std::vector<bool>& is_walked);

}  // namespace stream_recon
