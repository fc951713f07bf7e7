// The stars of the vertices that a chunk owns: all triangles of the surface at each.
//
// Guarantees: every vertex of a triangle whose rank lies in the chunk comes once, in ascending
// order, with all of its triangles, in any order. Thread rule: one thread. Memory: 28 bytes a
// triangle at a vertex of the chunk, 4 a point, from the budget. Cost: about 100 ns a triangle.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/budget.h"
#include "engine/surface/buckets.h"
#include "engine/surface/facet_export.h"
#include "engine/surface/sheet_records.h"

namespace stream_recon {

class VertexStars {
 public:
  /// \throw IoError, BudgetError; std::logic_error a facet does not say which way it faces
  VertexStars(const ExportedFacets& surface, std::uint64_t chunk, MemoryBudget& budget);

  /// Bytes for chunks of so many triangles and points.
  static constexpr std::uint64_t memory(std::uint64_t triangles, std::uint64_t points) {
    return triangles * (sizeof(Facet) + 3 * sizeof(std::uint32_t)) + points * sizeof(std::uint32_t);
  }

  /// Calls visit(star) for each vertex; the star lasts until it returns.
  template <class Visit>
  void for_each(const Visit& visit) const {
    std::vector<StarTriangle> star;
    places_.for_each([&](std::uint32_t begin, std::uint32_t end) {
      if (begin == end) return;
      make_star(std::span(corners_).subspan(begin, end - begin), star);
      visit(std::span<const StarTriangle>(star));
    });
  }

 private:
  struct Facet {
    std::array<ShortRank, 3> ranks{};
    std::uint32_t is_outward = 0;
  };

  void take(std::span<const FacetRecord> records);
  void sort_corners(PointRank first, PointRank end);
  void make_star(std::span<const std::uint32_t> corners, std::vector<StarTriangle>& star) const;

  Reservation memory_;
  std::vector<Facet> facets_;
  std::vector<std::uint32_t> corners_;  ///< 3 * facet + corner, by vertex
  Buckets places_;                      ///< of each vertex in corners_
};

}  // namespace stream_recon
