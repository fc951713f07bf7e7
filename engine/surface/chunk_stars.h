// All facets of a solid at the points of one chunk: its own, then those of earlier chunks.
//
// Guarantees: the whole star of each point of the chunk; own triangles keep their numbers. Thread
// rule: a value. Memory: 12 bytes a facet, 8 a vertex; 36 more a border facet and 4 a vertex while
// it is made.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/surface/chunk_facets.h"

namespace stream_recon {

struct ChunkStars {
  /// \param border facets of earlier chunks with a point in the chunk, any order
  ChunkStars(const ChunkFacets& own_facets, std::span<const FacetRecord> border);

  /// Of the lowest vertex that has no lower rank.
  std::uint32_t position(PointRank rank) const;

  /// The third corner of the triangle that uses an edge, a position.
  std::uint32_t apex(const EdgeUse& use) const {
    constexpr std::array<int, 3> kApexOfSide{2, 0, 1};
    return triangles[use.triangle()][kApexOfSide[use.use % 3]];
  }
  /// Whether the triangle runs along the edge from low to high, seen from outside.
  bool rises(const EdgeUse& use) const { return use.ascending() == is_outward[use.triangle()]; }
  bool is_own(const EdgeUse& use) const { return use.triangle() < own; }

  std::vector<PointRank> ranks;          ///< of all vertices, ascending
  std::vector<LocalTriangle> triangles;  ///< positions in ranks, ascending
  std::vector<bool> is_outward;          ///< of each triangle: facing of its ascending order
  std::uint32_t own = 0;                 ///< triangles of the chunk

 private:
  void add_own(const ChunkFacets& facets);
};

}  // namespace stream_recon
