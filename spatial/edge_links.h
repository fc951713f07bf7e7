// Joins the new cells around an inserted point: each edge of the conflict zone's boundary is shared
// by two of them.
//
// How: the boundary is a closed, oriented triangulated surface, so every directed edge belongs to
// one new cell and its reverse to the other. Each cell writes its facet under its three directed
// edges, then reads what stands under the reversed ones. Up to kSmall vertices get small labels and
// the table is a plain array that is never cleared; larger boundaries use a hash table.
// Memory: a byte a vertex of the triangulation, 16 KiB, and the largest boundary seen.
// Thread rule: one writer. Cost: linear in the boundary.
#pragma once

#include <cstdint>
#include <vector>

#include "spatial/cell_array.h"
#include "spatial/growable_array.h"

namespace stream_recon::detail {

class EdgeLinks {
 public:
  /// Boundaries of this many facets have at most kSmall vertices (Euler).
  static constexpr std::size_t kSmall = 64;
  static constexpr std::size_t kSmallFacets = 2 * kSmall - 4;

  /// Labels for vertices 0 .. count - 1.
  void reserve_vertices(std::size_t count) { labels_.reserve(count); }

  /// Sets the links among `facets`: for every new cell the facet opposite the inserted point.
  void join(CellArray& cells, const std::vector<std::uint32_t>& facets);

  std::size_t bytes() const;

 private:
  void join_few(CellArray& cells, const std::vector<std::uint32_t>& facets);
  void join_many(CellArray& cells, const std::vector<std::uint32_t>& facets);

  struct DirectedEdge {
    std::uint64_t ends;  // 0 where the slot is empty: no edge joins infinity to itself
    std::uint32_t facet;
  };
  DirectedEdge& slot(std::uint64_t ends);

  GrowableArray<std::uint8_t> labels_;  // 0: none yet
  std::vector<std::uint32_t> small_table_ = std::vector<std::uint32_t>(kSmall * kSmall);
  std::vector<std::uint16_t> reversed_ = std::vector<std::uint16_t>(3 * kSmallFacets);
  std::vector<DirectedEdge> large_table_;
};

}  // namespace stream_recon::detail
