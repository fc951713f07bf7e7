// The cloud in Hilbert order, duplicates merged: what the rank of a point means.
//
// Guarantees: at(r) is the point of rank r; ranks are 0 .. count() - 1 in the order of (Hilbert
// key, x, y, z). Thread rule: one thread a reader; read_points() is thread-safe. Memory: two blocks
// of 32 KiB and a codec a reader, three and a codec a call of read_points().
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/order/stored_point.h"
#include "engine/scratch_records.h"

namespace stream_recon {

/// Name of the store (records of StoredPoint) in the scratch directory.
inline constexpr const char* kPointStore = "points";

/// Small, because facets at chunk borders fetch points one by one.
inline constexpr std::size_t kPointStoreBlock = std::size_t{32} << 10;

using PointStoreReader = ScratchReader<StoredPoint>;

/// The store itself, for several threads.
using PointStoreFile = RecordFile<StoredPoint>;

/// The points of `ranks`, which ascend, to the ends of the two lists. \throw IoError
void read_points(const PointStoreFile& store, std::span<const std::uint64_t> ranks,
                 std::vector<Point3>& points, std::vector<std::uint64_t>& input_indices);

}  // namespace stream_recon
