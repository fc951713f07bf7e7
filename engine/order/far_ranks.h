// Where the far points, which are no samples, stand in the order of the point store.
//
// Guarantees: ascending; eight where ingest added them, else none. Thread rule: pure. Cost: one
// pass over the point store.
#pragma once

#include <cstdint>
#include <vector>

#include "engine/order/ingest.h"
#include "engine/stage_context.h"

namespace stream_recon {

/// \throw IoError
std::vector<std::uint32_t> far_ranks(const CloudSummary& cloud, const StageContext& context);

}  // namespace stream_recon
