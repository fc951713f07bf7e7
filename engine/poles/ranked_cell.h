// A finite tetrahedron with its corners by ascending rank: the order in which every window sees it.
//
// Thread rule: a value. Cost: about 5 ns.
#pragma once

#include <array>
#include <cstdint>
#include <utility>

#include "engine/labels/evidence_records.h"
#include "engine/windows/final_window.h"
#include "spatial/cell_view.h"
#include "spatial/point.h"

namespace stream_recon {

struct RankedCell {
  std::array<VertexId, 4> vertices;
  std::array<PointRank, 4> ranks;
  std::array<int, 4> sides;  ///< which vertex of the cell each is

  RankedCell(const FinalWindow& window, const CellView& cells, CellId cell)
      : vertices(cells.vertices(cell)), sides{0, 1, 2, 3} {
    for (int i = 0; i < 4; ++i) ranks[i] = window.rank(vertices[i]);
    order(0, 1);
    order(2, 3);
    order(0, 2);
    order(1, 3);
    order(1, 2);
  }

  /// \pre Ranks have 32 bits.
  NodeKey key() const {
    NodeKey key;
    for (int i = 0; i < 4; ++i) key.ranks[i] = static_cast<std::uint32_t>(ranks[i]);
    return key;
  }

  std::array<Point3, 4> corners(const CellView& cells) const {
    return {cells.point(vertices[0]), cells.point(vertices[1]), cells.point(vertices[2]),
            cells.point(vertices[3])};
  }

 private:
  void order(int i, int j) {
    if (ranks[i] < ranks[j]) return;
    std::swap(ranks[i], ranks[j]);
    std::swap(vertices[i], vertices[j]);
    std::swap(sides[i], sides[j]);
  }
};

}  // namespace stream_recon
