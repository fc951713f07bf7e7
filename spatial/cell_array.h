// The cells of the Delaunay kernel: four vertices and four links each, 32 bytes.
//
// Invariants: a link names the facet on the other side, so that it is walked and mended without a
// search: if cell c has facet_link(d, j) as its link i, then cell d has facet_link(c, i) as its
// link j. Inside the kernel vertices count from 1; 0 is the vertex at infinity and always the
// fourth of its cell. Every cell is positively oriented (an infinite one as if its last vertex lay
// far outside). A cell marked dead is free, or lies in the conflict zone of the point in hand.
// Memory: 32 bytes a slot; free slots are used again, the last freed first, while still cached.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "spatial/growable_array.h"

namespace stream_recon::detail {

struct Cell {
  std::uint32_t vertex[4];  // the first carries the mark
  std::uint32_t link[4];    // link i crosses the facet opposite vertex i
};
static_assert(sizeof(Cell) == 32);

inline constexpr std::uint32_t kDead = std::uint32_t{1} << 31;

inline bool is_dead(const Cell& cell) {
  return (cell.vertex[0] & kDead) != 0;
}
inline bool is_infinite(const Cell& cell) {
  return cell.vertex[3] == 0;
}
inline std::uint32_t vertex_of(const Cell& cell, int i) {
  return cell.vertex[i] & ~kDead;
}

/// A facet seen from a cell: cell and facet number in one word. Cells are below 2^30.
inline std::uint32_t facet_link(std::uint32_t cell, std::uint32_t facet) {
  return cell << 2 | facet;
}
inline std::uint32_t cell_of(std::uint32_t link) {
  return link >> 2;
}
inline std::uint32_t facet_of(std::uint32_t link) {
  return link & 3;
}

/// The vertices of facet i in an order that makes (i, first, second, third) an even permutation.
inline constexpr std::uint8_t kFacet[4][3] = {{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}};

class CellArray {
 public:
  static constexpr std::size_t kMostCells = std::size_t{1} << 30;

  /// Room for `count` more slots; false if that would exceed `most` slots in all.
  bool make_room(std::size_t count, std::size_t most) {
    const std::size_t needed = size_ + count;
    if (needed <= cells_.capacity()) return true;
    if (needed > most) return false;
    cells_.reserve(std::min(std::max(needed, 2 * cells_.capacity()), most));
    return true;
  }

  /// \pre make_room() covered it
  std::uint32_t allocate() {
    if (free_.empty()) return static_cast<std::uint32_t>(size_++);
    const std::uint32_t cell = free_.back();
    free_.pop_back();
    return cell;
  }
  void release(const std::uint32_t* cells, std::size_t count) {
    free_.insert(free_.end(), cells, cells + count);
  }

  Cell& operator[](std::size_t i) { return cells_[i]; }
  const Cell& operator[](std::size_t i) const { return cells_[i]; }
  const Cell* data() const { return cells_.data(); }
  /// Slots in use and free ones among them.
  std::size_t size() const { return size_; }
  std::size_t bytes() const {
    return size_ * sizeof(Cell) + free_.capacity() * sizeof(std::uint32_t);
  }

 private:
  GrowableArray<Cell> cells_;
  std::size_t size_ = 0;
  std::vector<std::uint32_t> free_;
};

}  // namespace stream_recon::detail
