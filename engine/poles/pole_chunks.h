// How many poles each chunk of the medial axis has: they lie in the store one chunk after the
// other.
//
// Thread rule: one thread until finish(), then const for many. Memory: 16 bytes a chunk, from the
// budget.
#pragma once

#include <cstdint>
#include <vector>

#include "engine/budget.h"

namespace stream_recon {

class PoleChunks {
 public:
  PoleChunks(std::uint64_t chunks, MemoryBudget& budget)
      : memory_(budget.reserve((chunks + 1) * sizeof(Chunk), "the chunks of the medial axis")),
        chunks_(chunks + 1) {}

  void add(std::uint64_t chunk, bool is_taken) {
    ++chunks_[chunk + 1].first;
    chunks_[chunk].taken += is_taken ? 1 : 0;
  }
  /// All are added.
  void finish() {
    for (std::size_t i = 1; i < chunks_.size(); ++i) chunks_[i].first += chunks_[i - 1].first;
  }

  /// Of all chunks.
  std::vector<std::uint64_t> ends() const {
    std::vector<std::uint64_t> ends;
    for (std::size_t i = 1; i < chunks_.size(); ++i) ends.push_back(chunks_[i].first);
    return ends;
  }
  std::uint64_t first(std::uint64_t chunk) const { return chunks_[chunk].first; }
  std::uint64_t end(std::uint64_t chunk) const { return chunks_[chunk + 1].first; }
  /// Of those that are taken.
  std::uint64_t count(std::uint64_t chunk) const { return chunks_[chunk].taken; }

 private:
  struct Chunk {
    std::uint64_t first = 0;  ///< until finish(): how many the chunk before has
    std::uint64_t taken = 0;
  };
  Reservation memory_;
  std::vector<Chunk> chunks_;
};

}  // namespace stream_recon
