// The cloud in Hilbert order, duplicates merged: what the rank of a point means.
//
// Guarantees: at(r) is the point of rank r; ranks are 0 .. count() - 1 in the order of (Hilbert
// key, x, y, z). Thread rule: one thread a reader. Memory: two blocks of 32 KiB and a codec.
#pragma once

#include "engine/order/stored_point.h"
#include "engine/scratch_records.h"

namespace stream_recon {

/// Name of the store (records of StoredPoint) in the scratch directory.
inline constexpr const char* kPointStore = "points";

/// Small, because facets at chunk borders fetch points one by one.
inline constexpr std::size_t kPointStoreBlock = std::size_t{32} << 10;

using PointStoreReader = ScratchReader<StoredPoint>;

}  // namespace stream_recon
