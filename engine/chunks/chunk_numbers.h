// The numbers of the chunks that are written: those with records, in their order.
//
// Thread rule: const for many threads. Memory: 8 bytes a chunk, from the budget.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "engine/budget.h"

namespace stream_recon {

class ChunkNumbers {
 public:
  /// \param spool tells by count(chunk) how many records a chunk has \throw BudgetError
  template <class Spool>
  ChunkNumbers(const Spool& spool, std::uint64_t chunks, MemoryBudget& budget)
      : memory_(budget.reserve(chunks * sizeof numbers_[0], "the numbers of the chunks")) {
    numbers_.reserve(chunks);
    std::uint64_t next = 0;
    for (std::uint64_t chunk = 0; chunk < chunks; ++chunk) {
      numbers_.push_back(next);
      next += spool.count(chunk) != 0 ? 1 : 0;
      most_records_ = std::max(most_records_, spool.count(chunk));
    }
  }

  std::uint64_t number(std::uint64_t chunk) const { return numbers_[chunk]; }
  /// Of the largest chunk.
  std::uint64_t most_records() const { return most_records_; }

 private:
  Reservation memory_;
  std::vector<std::uint64_t> numbers_;
  std::uint64_t most_records_ = 0;
};

}  // namespace stream_recon
