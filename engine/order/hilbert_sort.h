// Sorts the ingested points along the Hilbert curve and merges duplicates, within the budget.
//
// Guarantees: the point store (point_store.h) holds each distinct point once, under its lowest
// input index, ordered by (Hilbert key, x, y, z); its bytes do not depend on memory or threads.
// A cloud that fits the budget is sorted in one run that never touches the disk; else runs are
// merged, in several passes where they are too many. Thread rule: one caller; works on all
// threads. Memory: 40 bytes a point of a run, as much as `budget` has.
#pragma once

#include <cstdint>

#include "engine/order/ingest.h"

namespace stream_recon {

struct OrderResult {
  std::uint64_t point_count = 0;  ///< distinct points
  std::uint64_t duplicates = 0;
};

/// Reads the ingest spool. \throw IoError, BudgetError, Interrupted
OrderResult hilbert_sort(const CloudSummary& cloud, const StageContext& context);

}  // namespace stream_recon
