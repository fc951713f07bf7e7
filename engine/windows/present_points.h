// Which points of the cloud a window has: whole leaves, and single points beside them.
//
// Thread rule: one window's. Memory: a bit a leaf of the cloud (8 bytes for 1000 points), and 40
// bytes a single point. Cost: 1 ns a leaf, 20 ns a point.
#pragma once

#include <algorithm>
#include <cstdint>
#include <unordered_set>
#include <vector>

#include "engine/windows/index_layout.h"

namespace stream_recon {

class PresentPoints {
 public:
  static std::uint64_t memory(std::uint64_t leaf_count) { return leaf_count / 8 + 8; }

  explicit PresentPoints(std::uint64_t leaf_count)
      : leaf_count_(leaf_count), words_(leaf_count / 64 + 1) {}

  void clear() {
    std::fill(words_.begin(), words_.end(), 0);
    singles_.clear();
  }

  /// Whether it was missing.
  bool add_leaf(index_layout::LeafNumber leaf) {
    std::uint64_t& word = words_[leaf / 64];
    const std::uint64_t bit = std::uint64_t{1} << leaf % 64;
    const bool is_new = (word & bit) == 0;
    word |= bit;
    return is_new;
  }
  /// Whether it was missing.
  bool add_single(PointRank rank) {
    return !has_leaf(index_layout::leaf_of(rank)) && singles_.insert(rank).second;
  }

  bool has_leaf(index_layout::LeafNumber leaf) const {
    return (words_[leaf / 64] >> leaf % 64 & 1) != 0;
  }
  /// Leaves beyond the end of the cloud do not count.
  bool has_leaves(const index_layout::LeafRange& range) const {
    index_layout::LeafNumber leaf = range.begin;
    const index_layout::LeafNumber end = std::min(range.end, leaf_count_);
    while (leaf < end) {
      if (leaf % 64 == 0 && leaf + 64 <= end) {
        if (words_[leaf / 64] != ~std::uint64_t{0}) return false;
        leaf += 64;
      } else if (!has_leaf(leaf++)) {
        return false;
      }
    }
    return true;
  }
  bool is_single(PointRank rank) const { return singles_.contains(rank); }

 private:
  index_layout::LeafNumber leaf_count_;
  std::vector<std::uint64_t> words_;
  std::unordered_set<PointRank> singles_;
};

}  // namespace stream_recon
