// The cells and points of a Delaunay structure as they lie in memory, for loops over all of them:
// every question is answered in place, without a call.
//
// Guarantees: answers as Delaunay's own, which documents them. Thread rule: a view, const access
// from many; it lives until the next insertion.
#pragma once

#include <array>

#include "spatial/cell_array.h"
#include "spatial/delaunay.h"
#include "spatial/site.h"

namespace stream_recon {

/// \tparam Site Point3 or WeightedPoint3
template <class Site>
class BasicCellView {
 public:
  struct Parts {
    const detail::Cell* cells = nullptr;
    CellId slots = 0;
    const Site* points = nullptr;  ///< of vertex v at v + 1, multiplied by `scale`
    double scale = 1;              ///< a power of two
  };

  explicit BasicCellView(const Parts& parts) : parts_(parts), unscale_(1 / parts.scale) {}

  CellId slots() const { return parts_.slots; }
  bool is_live(CellId c) const { return !detail::is_dead(parts_.cells[c]); }
  bool is_infinite(CellId c) const { return detail::is_infinite(parts_.cells[c]); }

  /// The cell is asked about soon.
  void prefetch(CellId c) const { __builtin_prefetch(&parts_.cells[c]); }

  VertexId vertex(CellId c, int i) const {
    // Infinity, 0 inside, becomes kInfinite by wrapping around; the mark of the dead goes as well.
    return (parts_.cells[c].vertex[i] - 1) & Delaunay::kInfinite;
  }
  std::array<VertexId, 4> vertices(CellId c) const {
    return {vertex(c, 0), vertex(c, 1), vertex(c, 2), vertex(c, 3)};
  }
  /// The vertices of facet i, seen counterclockwise from outside the cell.
  std::array<VertexId, 3> facet(CellId c, int i) const {
    const std::uint8_t* corner = detail::kFacet[i];
    return {vertex(c, corner[0]), vertex(c, corner[1]), vertex(c, corner[2])};
  }

  CellId neighbor(CellId c, int i) const { return detail::cell_of(parts_.cells[c].link[i]); }
  int mirror_index(CellId c, int i) const {
    return static_cast<int>(detail::facet_of(parts_.cells[c].link[i]));
  }

  /// Whether the points are stored as they are.
  bool is_unscaled() const { return parts_.scale == 1; }
  /// The corners of a cell are asked for soon.
  void prefetch_points(CellId c) const {
    for (int i = 0; i < 4; ++i) prefetch_point(vertex(c, i));
  }
  void prefetch_point(VertexId v) const { __builtin_prefetch(&stored_point(v)); }
  /// The point as stored: multiplied by the scale.
  const Site& stored_point(VertexId v) const { return parts_.points[v + 1]; }
  Site point(VertexId v) const { return scaled(stored_point(v), unscale_); }
  /// Of a finite cell.
  std::array<Site, 4> corners(CellId c) const {
    return {point(vertex(c, 0)), point(vertex(c, 1)), point(vertex(c, 2)), point(vertex(c, 3))};
  }

 private:
  Parts parts_;
  double unscale_;
};

}  // namespace stream_recon
