// The tetrahedra and facets that a window emits: those whose vertex of lowest rank it owns, so that
// all windows together emit each simplex of the cloud exactly once.
//
// Thread rule: disjoint cell ranges may be visited side by side. Cost: one look at each cell.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

#include "engine/windows/final_window.h"
#include "spatial/cell_view.h"

namespace stream_recon {

struct CellRange {
  CellId begin = 0;
  CellId end = 0;
};

/// Whether the window owns one of the vertices; infinity counts as one that is not owned.
inline bool has_owned(const FinalWindow& window, const std::array<VertexId, 4>& v) {
  return window.owns_vertex(std::min(std::min(v[0], v[1]), std::min(v[2], v[3])));
}

/// Whether the window emits the simplex of these vertices.
template <std::size_t kCorners>
bool emits(const FinalWindow& window, const std::array<VertexId, kCorners>& vertices) {
  std::size_t owned = 0;
  for (const VertexId v : vertices) owned += window.owns_vertex(v) ? 1 : 0;
  if (owned == 0 || owned == kCorners) return owned != 0;
  PointRank lowest = window.rank(vertices[0]);
  for (const VertexId v : vertices) lowest = std::min(lowest, window.rank(v));
  return window.owns(lowest);
}

/// Whether the window emits the tetrahedron of these vertices or one of its finite facets. The
/// other tetrahedra with an owned vertex are for other windows.
inline bool emits_part(const FinalWindow& window, const std::array<VertexId, 4>& vertices) {
  int owned = 0;
  int earlier = 0;
  for (const VertexId v : vertices) {
    if (v == Delaunay::kInfinite) continue;
    owned += window.owns_vertex(v) ? 1 : 0;
    earlier += !window.owns_vertex(v) && window.rank(v) < window.first_rank() ? 1 : 0;
  }
  const bool is_infinite = vertices[3] == Delaunay::kInfinite;
  return owned > 0 && earlier <= (is_infinite ? 0 : 1);
}

/// Calls visit(cell) for each finite tetrahedron of the range that the window emits.
template <class Visit>
void for_each_final_tetrahedron(const FinalWindow& window, CellRange range, const Visit& visit) {
  const CellView cells = window.delaunay().view();
  for (CellId cell = range.begin; cell < range.end; ++cell) {
    if (!cells.is_live(cell) || cells.is_infinite(cell)) continue;
    if (emits(window, cells.vertices(cell))) visit(cell);
  }
}

/// Calls visit(cell, side) for each finite facet that the window emits, from the finite cell of
/// lower number among its two; that cell lies in the range.
template <class Visit>
void for_each_final_facet(const FinalWindow& window, CellRange range, const Visit& visit) {
  const CellView cells = window.delaunay().view();
  for (CellId cell = range.begin; cell < range.end; ++cell) {
    if (!cells.is_live(cell) || cells.is_infinite(cell)) continue;
    for (int side = 0; side < 4; ++side) {
      const CellId beyond = cells.neighbor(cell, side);
      if (beyond < cell && !cells.is_infinite(beyond)) continue;
      if (emits(window, cells.facet(cell, side))) visit(cell, side);
    }
  }
}

}  // namespace stream_recon
