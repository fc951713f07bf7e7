#include "engine/tetrahedra/chunk_vertices.h"

#include <algorithm>
#include <functional>

#include "engine/parallel.h"

namespace stream_recon {
namespace {

constexpr std::size_t kFirstRoom = 1 << 12;

}  // namespace

ChunkVertices::ChunkVertices(PointRank first, PointRank end, MemoryBudget& budget)
    : first_(first),
      memory_(budget.reserve((end - first) * sizeof(std::uint32_t),
                             "the points of a chunk (a smaller --chunk-points needs less)")),
      own_(end - first, kUnused) {}

void ChunkVertices::make_distinct() {
  parallel_sort(later_.begin(), later_.end(), std::less<>());
  later_.erase(std::unique(later_.begin(), later_.end()), later_.end());
}

void ChunkVertices::make_room() {
  make_distinct();
  const std::size_t room = later_.capacity();
  // Half of the room must be gained, or it would be sorted over and over.
  if (later_.size() < room / 2) return;
  const std::size_t more = std::max(kFirstRoom, 2 * room);
  const std::uint64_t own_bytes = own_.size() * sizeof(std::uint32_t);
  memory_.resize(own_bytes + (room + more) * sizeof(PointRank));
  later_.reserve(more);
  memory_.resize(own_bytes + more * sizeof(PointRank));
}

void ChunkVertices::number() {
  for (std::uint32_t& position : own_) {
    if (position != kUnused) position = own_ranks_++;
  }
  make_distinct();
}

std::uint32_t ChunkVertices::position(PointRank rank) const {
  if (rank - first_ < own_.size()) return own_[rank - first_];
  const auto at = std::lower_bound(later_.begin(), later_.end(), rank);
  return own_ranks_ + static_cast<std::uint32_t>(at - later_.begin());
}

}  // namespace stream_recon
