// The tetrahedra and facets that a window emits: those whose vertex of lowest rank it owns, so that
// all windows together emit each simplex of the cloud exactly once.
//
// Thread rule: disjoint cell ranges may be visited side by side. Cost: one look at each cell.
#pragma once

#include <algorithm>
#include <array>

#include "engine/windows/final_window.h"

namespace stream_recon {

struct CellRange {
  CellId begin = 0;
  CellId end = 0;
};

/// Calls visit(cell) for each finite tetrahedron of the range that the window emits.
template <class Visit>
void for_each_final_tetrahedron(const FinalWindow& window, CellRange range, const Visit& visit) {
  const Delaunay& delaunay = window.delaunay();
  for (CellId cell = range.begin; cell < range.end; ++cell) {
    if (!delaunay.is_live(cell) || delaunay.is_infinite(cell)) continue;
    const auto v = delaunay.vertices(cell);
    const PointRank lowest = std::min(std::min(window.rank(v[0]), window.rank(v[1])),
                                      std::min(window.rank(v[2]), window.rank(v[3])));
    if (window.owns(lowest)) visit(cell);
  }
}

/// The three vertices opposite vertex `side` of a cell, seen counterclockwise from outside the
/// cell.
inline std::array<VertexId, 3> facet_vertices(const Delaunay& delaunay, CellId cell, int side) {
  static constexpr int kFacet[4][3] = {{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}};
  const auto v = delaunay.vertices(cell);
  return {v[kFacet[side][0]], v[kFacet[side][1]], v[kFacet[side][2]]};
}

/// Calls visit(cell, side) for each finite facet that the window emits, from the finite cell of
/// lower number among its two; that cell lies in the range.
template <class Visit>
void for_each_final_facet(const FinalWindow& window, CellRange range, const Visit& visit) {
  const Delaunay& delaunay = window.delaunay();
  for (CellId cell = range.begin; cell < range.end; ++cell) {
    if (!delaunay.is_live(cell) || delaunay.is_infinite(cell)) continue;
    for (int side = 0; side < 4; ++side) {
      const CellId beyond = delaunay.neighbor(cell, side);
      if (beyond < cell && !delaunay.is_infinite(beyond)) continue;
      const auto v = facet_vertices(delaunay, cell, side);
      const PointRank lowest =
          std::min(window.rank(v[0]), std::min(window.rank(v[1]), window.rank(v[2])));
      if (window.owns(lowest)) visit(cell, side);
    }
  }
}

}  // namespace stream_recon
