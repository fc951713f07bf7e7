// The points that the simplices of one chunk use, numbered by rank.
//
// Guarantees: positions are 0 .. size() - 1 in the order of the ranks, whatever order and however
// often they were added in. Thread rule: one thread while points are added, then const for many.
// Memory: 3 bits a point of the chunk, up to 16 bytes a distinct point of later chunks, from the
// budget. Cost: linear, but for the points of later chunks, which are sorted and looked up.
#pragma once

#include <bit>
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
    const std::uint64_t place = rank - first_;
    if (place < own_points_) {
      own_[place / kBits].used |= std::uint64_t{1} << place % kBits;
    } else {
      if (later_.size() == later_.capacity()) make_room();
      later_.push_back(rank);
    }
  }
  /// No more points.
  void number();

  std::uint64_t size() const { return own_ranks_ + later_.size(); }
  /// \pre number(), the rank was added
  std::uint32_t position(PointRank rank) const {
    const std::uint64_t place = rank - first_;
    if (place >= own_points_) return later_position(rank);
    const Word& word = own_[place / kBits];
    const std::uint64_t below = (std::uint64_t{1} << place % kBits) - 1;
    return word.before + static_cast<std::uint32_t>(std::popcount(word.used & below));
  }

  /// All of them, ascending. \pre number()
  std::vector<PointRank> ranks() const;

  /// Calls visit(rank) for all points, ascending. \pre number()
  template <class Visit>
  void for_each(const Visit& visit) const {
    for (std::uint64_t i = 0; i < own_.size(); ++i) {
      for (std::uint64_t rest = own_[i].used; rest != 0; rest &= rest - 1) {
        visit(first_ + i * kBits + static_cast<unsigned>(std::countr_zero(rest)));
      }
    }
    for (const PointRank rank : later_) visit(rank);
  }

 private:
  static constexpr std::uint64_t kBits = 64;

  /// Points of the chunk, one after the other.
  struct Word {
    std::uint64_t used = 0;    ///< a bit each
    std::uint32_t before = 0;  ///< how many of those in earlier words are used
  };

  std::uint32_t later_position(PointRank rank) const;
  void make_distinct();
  void make_room();

  PointRank first_;
  std::uint64_t own_points_;
  Reservation memory_;
  std::vector<Word> own_;
  std::uint32_t own_ranks_ = 0;   ///< how many points of the chunk are used
  std::vector<PointRank> later_;  ///< of later chunks; distinct and ascending in the end
};

}  // namespace stream_recon
