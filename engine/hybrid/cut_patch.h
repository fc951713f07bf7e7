// A patch from the crust, if the crust gives one: see engine/hybrid/patch.h.
//
// Rounds: walks along the rings, the region they enclose, its merging; the edges of the hole where
// one of these fails are where the next round keeps fills. The second round has a finer crust, with
// more room for walks beside each other.
#pragma once

#include <optional>
#include <vector>

#include "engine/hybrid/patch.h"

namespace stream_recon {

/// \param rings of the hole
std::optional<Patch> cut_patch(const Hole& hole,
                               const std::vector<std::vector<std::uint32_t>>& rings,
                               const CrustPiece& crust, const PatchOptions& options);

}  // namespace stream_recon
