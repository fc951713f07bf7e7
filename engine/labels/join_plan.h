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

struct JoinPlan {
  std::vector<std::size_t> ends;  ///< of each group of consecutive parts
  std::uint64_t at_once = 1;      ///< groups that are joined side by side
};

struct JoinResources {
  std::uint64_t memory_bytes = 0;
  std::uint64_t threads = 1;
};

/// As many groups side by side, of about as many nodes each, as there are threads, while the memory
/// lets the parts become half as many; else as many parts in each group as it holds, at least one.
JoinPlan plan_joins(std::span<const EvidencePart> parts, const JoinResources& resources);

/// What joining any two neighbours takes at least, bytes. \pre There are two
std::uint64_t least_join_memory(std::span<const EvidencePart> parts);

}  // namespace stream_recon
