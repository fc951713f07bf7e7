// A hole without some of its fills.
//
// Thread rule: pure. Memory: 8 bytes a point and what the part has. Cost: linear.
#pragma once

#include <cstdint>
#include <vector>

#include "engine/hybrid/hole.h"

namespace stream_recon {

struct HolePart {
  Hole hole;                           ///< the other fills, and points only where they have corners
  std::vector<std::uint32_t> numbers;  ///< of its points, in the whole hole
};

/// \param is_kept of each fill: not in the part
HolePart hole_without(const Hole& hole, const std::vector<bool>& is_kept);

}  // namespace stream_recon
