// Which sites of a regular triangulation are hidden: no vertex of any cell, because heavier sites
// around them leave them no power cell.
//
// Guarantees: hidden stays hidden while sites are added. Thread rule: one writer; const access from
// many. Memory: a bit a site.
#pragma once

#include <cstddef>
#include <cstdint>

#include "spatial/growable_array.h"

namespace stream_recon::detail {

class HiddenVertices {
 public:
  /// Vertices 0 .. count - 1.
  void reserve(std::size_t count) { words_.reserve(count / 64 + 1); }

  /// \pre The vertex is not hidden yet.
  void add(std::uint32_t vertex) {
    words_[vertex / 64] |= std::uint64_t{1} << vertex % 64;
    ++count_;
  }
  bool contains(std::uint32_t vertex) const { return words_[vertex / 64] >> vertex % 64 & 1; }
  std::size_t count() const { return count_; }

 private:
  GrowableArray<std::uint64_t> words_;
  std::size_t count_ = 0;
};

}  // namespace stream_recon::detail
