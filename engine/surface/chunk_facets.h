// The facets of one chunk in memory, in the order they are written.
//
// Guarantees: facets ascend by rank triple; vertices are their distinct ranks, ascending; the local
// triangles are the facets with ranks replaced by positions in the vertices, so they ascend too.
// Thread rule: a value. Memory: 44 bytes a facet, 8 a vertex; 24 more a facet while it is made.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/surface/edge_uses.h"
#include "engine/surface/facet_record.h"

namespace stream_recon {

/// Distinct ranks of the facets' vertices, ascending. Memory: 24 bytes a facet while it works.
std::vector<PointRank> vertex_ranks(std::span<const FacetRecord> facets);

struct ChunkFacets {
  /// \param records of one chunk, any order
  explicit ChunkFacets(std::vector<FacetRecord> records);

  std::vector<FacetRecord> facets;
  std::vector<PointRank> vertices;
  std::vector<LocalTriangle> triangles;
};

}  // namespace stream_recon
