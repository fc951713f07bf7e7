#include "engine/chunks/chunk_vertices.h"

#include <algorithm>

namespace stream_recon {
namespace {

constexpr std::size_t kFirstRoom = 1 << 12;

}  // namespace

ChunkVertices::ChunkVertices(PointRank first, PointRank end, MemoryBudget& budget)
    : first_(first),
      own_points_(end - first),
      memory_(budget.reserve((own_points_ / kBits + 1) * sizeof(Word),
                             "the points of a chunk (a smaller --chunk-points needs less)")),
      own_(own_points_ / kBits + 1) {}

void ChunkVertices::make_distinct() {
  std::sort(later_.begin(), later_.end());
  later_.erase(std::unique(later_.begin(), later_.end()), later_.end());
}

void ChunkVertices::make_room() {
  make_distinct();
  const std::size_t room = later_.capacity();
  // Half of the room must be gained, or it would be sorted over and over.
  if (later_.size() < room / 2) return;
  const std::size_t more = std::max(kFirstRoom, 2 * room);
  const std::uint64_t own_bytes = own_.size() * sizeof(Word);
  memory_.resize(own_bytes + (room + more) * sizeof(PointRank));
  later_.reserve(more);
  memory_.resize(own_bytes + more * sizeof(PointRank));
}

void ChunkVertices::number() {
  for (Word& word : own_) {
    word.before = own_ranks_;
    own_ranks_ += static_cast<std::uint32_t>(std::popcount(word.used));
  }
  make_distinct();
}

std::vector<PointRank> ChunkVertices::ranks() const {
  std::vector<PointRank> ranks;
  ranks.reserve(size());
  for_each([&ranks](PointRank rank) { ranks.push_back(rank); });
  return ranks;
}

std::uint32_t ChunkVertices::later_position(PointRank rank) const {
  const auto at = std::lower_bound(later_.begin(), later_.end(), rank);
  return own_ranks_ + static_cast<std::uint32_t>(at - later_.begin());
}

}  // namespace stream_recon
