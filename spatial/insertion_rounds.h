// The order in which points are inserted: rounds of growing size, each along the curve on which the
// points lie.
//
// Guarantees: every position of [first, last) is visited once; a position's round depends on the
// position alone. Randomness between rounds bounds the expected work as if the order were random,
// the curve within a round keeps neighbours together in time and memory.
// Memory: none; each round scans the range and asks a hash. Cost: about 2 ns a position and round.
// Source: Amenta, Choi, Rote 2003 ("Incremental constructions con BRIO").
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>

namespace stream_recon::detail {

class InsertionRounds {
 public:
  /// Each round holds about kGrowth times the points of all rounds before it.
  static constexpr int kGrowth = 8;
  /// About this many points make the first round.
  static constexpr std::size_t kFirstRound = 64;

  explicit InsertionRounds(std::size_t count) {
    while (count / kGrowth >= kFirstRound) {
      ++last_;
      count /= kGrowth;
    }
  }

  /// Rounds are numbered from last() down to 0.
  int last() const { return last_; }

  int round_of(std::size_t position) const {
    // The finalizer of splitmix64: every bit of the position reaches every bit of the hash.
    std::uint64_t hash = position * 0x9e3779b97f4a7c15u;
    hash = (hash ^ hash >> 30) * 0xbf58476d1ce4e5b9u;
    hash = (hash ^ hash >> 27) * 0x94d049bb133111ebu;
    const int thirds = std::countr_zero(hash ^ hash >> 31) / std::countr_zero(unsigned{kGrowth});
    return thirds < last_ ? thirds : last_;
  }

 private:
  int last_ = 0;
};

}  // namespace stream_recon::detail
