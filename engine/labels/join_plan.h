// Which neighbouring parts of the evidence are joined in one go.
//
// Thread rule: pure functions.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/labels/evidence_part.h"

namespace stream_recon {

/// \return Where each group of consecutive parts ends, as many parts in each as `memory_bytes` hold
/// but at least one
std::vector<std::size_t> plan_joins(std::span<const EvidencePart> parts,
                                    std::uint64_t memory_bytes);

/// What joining any two neighbours takes at least, bytes. \pre There are two
std::uint64_t least_join_memory(std::span<const EvidencePart> parts);

}  // namespace stream_recon
