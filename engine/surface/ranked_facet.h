// A facet of a window with its vertices by ascending rank: the order in which every window sees it.
//
// Thread rule: a value. Source of the balls: spatial/facet_balls.h.
#pragma once

#include <array>
#include <utility>

#include "engine/windows/final_window.h"
#include "spatial/cell_view.h"
#include "spatial/facet_balls.h"
#include "spatial/point.h"

namespace stream_recon {

struct RankedFacet {
  std::array<VertexId, 3> vertices;
  std::array<PointRank, 3> ranks;
  bool reversed = false;  ///< an odd permutation of the order it was given in

  RankedFacet(const FinalWindow& window, const std::array<VertexId, 3>& v)
      : vertices(v), ranks{window.rank(v[0]), window.rank(v[1]), window.rank(v[2])} {
    order(0, 1);
    order(1, 2);
    order(0, 1);
  }

 private:
  void order(int i, int j) {
    if (ranks[i] < ranks[j]) return;
    std::swap(ranks[i], ranks[j]);
    std::swap(vertices[i], vertices[j]);
    reversed = !reversed;
  }
};

/// The balls beside facet `side` of a cell, the cell's own first. \pre the cell is finite
inline FacetBalls balls_beside(const CellView& cells, const RankedFacet& facet, CellId cell,
                               int side) {
  const std::array<Point3, 3> corners{cells.point(facet.vertices[0]),
                                      cells.point(facet.vertices[1]),
                                      cells.point(facet.vertices[2])};
  const Point3 apex = cells.point(cells.vertex(cell, side));
  const CellId beyond = cells.neighbor(cell, side);
  if (cells.is_infinite(beyond)) return hull_facet_balls(corners, apex);
  return facet_balls(corners, apex,
                     cells.point(cells.vertex(beyond, cells.mirror_index(cell, side))));
}

}  // namespace stream_recon
