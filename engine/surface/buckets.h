// Items dealt into numbered buckets: sorting by a small number in linear time.
//
// First count() each item, then start(), then slot() tells each item, in any order, a place of its
// own in an array that has the buckets one after the other; items of a bucket keep the order they
// ask in. Thread rule: a value. Memory: 4 bytes a bucket. Source: counting sort (Knuth, The Art of
// Computer Programming 3, section 5.2, algorithm D).
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace stream_recon {

class Buckets {
 public:
  explicit Buckets(std::size_t count) : next_(count, 0) {}

  void count(std::size_t bucket) { ++next_[bucket]; }

  /// All items were counted: at most 2^32 - 1.
  void start() {
    std::uint32_t begin = 0;
    for (std::uint32_t& next : next_) {
      const std::uint32_t items = next;
      next = begin;
      begin += items;
    }
  }

  /// \pre start()
  std::uint32_t slot(std::size_t bucket) { return next_[bucket]++; }

  /// Calls visit(begin, end) for the places of each bucket. \pre All items have a slot.
  template <class Visit>
  void for_each(const Visit& visit) const {
    std::uint32_t begin = 0;
    for (const std::uint32_t end : next_) {
      visit(begin, end);
      begin = end;
    }
  }

 private:
  std::vector<std::uint32_t> next_;
};

}  // namespace stream_recon
