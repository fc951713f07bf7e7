// Fills a conflict zone with the star of its point: a cell from every facet of the boundary.
//
// How the new cells find each other: the boundary is a closed, oriented triangulated surface, so
// every directed edge belongs to one new cell and its reverse to another. Each cell writes its
// facet under its three directed edges, then reads what stands under the reversed ones. Up to
// kSmall boundary vertices get small labels and the table is a plain array that is never cleared;
// a larger boundary uses a hash table.
// Memory: a byte a vertex of the triangulation, 18 KiB, and the largest boundary seen.
// Thread rule: one writer. Cost: linear in the boundary, about 28 cells a point of a random cloud.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "spatial/cell_array.h"
#include "spatial/conflict_zone.h"
#include "spatial/growable_array.h"

namespace stream_recon::detail {

class StarBuilder {
 public:
  /// A boundary of this many facets has kSmall vertices (Euler).
  static constexpr std::size_t kSmall = 64;
  static constexpr std::size_t kSmallFacets = 2 * kSmall - 4;

  /// Labels for vertices 0 .. count - 1.
  void reserve_vertices(std::size_t count) { labels_.reserve(count); }

  /// Replaces the cells of the zone by the star of the vertex; the star's last cell.
  /// \pre cells.make_room() covered the boundary
  std::uint32_t build(CellArray& cells, const ZoneLists& zone, std::uint32_t vertex);

  /// Appends the vertices of the zone that the last build() left without a cell, each once, to
  /// `swallowed`. Reads dead cells: \pre nothing was built since.
  void find_swallowed(const CellArray& cells, const ZoneLists& zone,
                      std::vector<std::uint32_t>& swallowed);

  std::size_t bytes() const;

 private:
  std::uint32_t build_cell(CellArray& cells, const SharedFacet& facet, std::uint32_t vertex);
  void link_few(CellArray& cells);
  void link_many(CellArray& cells);

  struct DirectedEdge {
    std::uint64_t ends;  // 0 where the slot is empty: no edge joins infinity to itself
    std::uint32_t facet;
  };
  DirectedEdge& slot(std::uint64_t ends);

  std::vector<std::uint32_t> built_;    // the facet opposite the vertex, of every new cell
  GrowableArray<std::uint8_t> labels_;  // 0: none yet
  std::vector<std::uint32_t> small_table_ = std::vector<std::uint32_t>(kSmall * kSmall);
  std::vector<std::uint16_t> reversed_ = std::vector<std::uint16_t>(3 * kSmallFacets);
  std::vector<DirectedEdge> large_table_;
};

}  // namespace stream_recon::detail
