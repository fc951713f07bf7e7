// How the cloud is cut into chunks of the output: runs of the Hilbert order.
//
// Guarantees: borders depend on the cloud and the points per chunk only, never on windows, threads
// or memory. A simplex belongs to the chunk of its vertex of lowest rank. Thread rule: a value.
#pragma once

#include <algorithm>
#include <cstdint>

#include "engine/windows/final_window.h"

namespace stream_recon {

struct ChunkLayout {
  std::uint64_t points_per_chunk = 1;
  std::uint64_t point_count = 0;

  std::uint64_t chunk_count() const {
    return point_count / points_per_chunk + (point_count % points_per_chunk != 0 ? 1 : 0);
  }
  std::uint64_t chunk_of(PointRank rank) const { return rank / points_per_chunk; }
  PointRank first_rank(std::uint64_t chunk) const { return chunk * points_per_chunk; }
  PointRank end_rank(std::uint64_t chunk) const {
    return std::min(first_rank(chunk) + points_per_chunk, point_count);
  }
  std::uint64_t points_in(std::uint64_t chunk) const { return end_rank(chunk) - first_rank(chunk); }
};

}  // namespace stream_recon
