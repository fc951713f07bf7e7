// The points that the simplices of one chunk use, numbered by rank.
//
// Guarantees: positions are 0 .. size() - 1 in the order of the ranks, whatever order and however
// often they were added in. Thread rule: one thread while points are added, then const for many.
// Memory: 4 bytes a point of the chunk, up to 16 a distinct point of later chunks, from the budget.
#pragma once

#include <cstdint>
#include <vector>

#include "engine/budget.h"
#include "engine/windows/final_window.h"

namespace stream_recon {

class ChunkVertices {
 public:
  /// \param first, end ranks of the chunk \throw BudgetError
  ChunkVertices(PointRank first, PointRank end, MemoryBudget& budget);

  /// \pre rank >= first \throw BudgetError
  void add(PointRank rank) {
    if (rank - first_ < own_.size()) {
      own_[rank - first_] = kUsed;
    } else {
      if (later_.size() == later_.capacity()) make_room();
      later_.push_back(rank);
    }
  }
  /// No more points.
  void number();

  std::uint64_t size() const { return own_ranks_ + later_.size(); }
  /// \pre number(), the rank was added
  std::uint32_t position(PointRank rank) const;

  /// Calls visit(rank) for all points, ascending. \pre number()
  template <class Visit>
  void for_each(const Visit& visit) const {
    for (std::uint64_t i = 0; i < own_.size(); ++i) {
      if (own_[i] != kUnused) visit(first_ + i);
    }
    for (const PointRank rank : later_) visit(rank);
  }

 private:
  static constexpr std::uint32_t kUnused = UINT32_MAX;
  static constexpr std::uint32_t kUsed = 0;

  void make_distinct();
  void make_room();

  PointRank first_;
  Reservation memory_;
  std::vector<std::uint32_t> own_;  ///< position of each point of the chunk
  std::uint32_t own_ranks_ = 0;     ///< how many of them are used
  std::vector<PointRank> later_;    ///< of later chunks; distinct and ascending in the end
};

}  // namespace stream_recon
