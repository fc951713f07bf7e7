// One chunk of the surface of a solid, with the facets of earlier chunks at its points: how its
// triangles hang together when each two that bound one wedge of the inside are joined.
//
// Guarantees: at each edge the inside decides, not the number of triangles, so that bodies that
// touch along an edge stay two; the result is a function of the facets and the chunk layout. Each
// vertex and edge of the whole surface is counted in one chunk, that of its lowest rank. Thread
// rule: const and pure. Memory: 64 bytes a triangle and 96 a border facet, 24 a vertex, and 40 a
// point at edges of more than two triangles, which is reserved. Cost: about 250 ns a triangle.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/budget.h"
#include "engine/order/point_store.h"
#include "engine/surface/chunk_facets.h"
#include "engine/surface/chunk_pieces.h"
#include "engine/surface/sheet_records.h"
#include "spatial/coordinate_range.h"

namespace stream_recon {

/// What is counted where the whole neighbourhood is known. All of them add up.
struct SolidCounts {
  std::uint64_t vertices = 0;
  std::uint64_t edges = 0;
  std::uint64_t boundary_edges = 0;
  std::uint64_t nonmanifold_edges = 0;
  std::uint64_t unpaired_uses = 0;  ///< of edges: triangles without a partner there
  std::uint64_t fans = 0;           ///< of triangles around vertices: one where all are joined
};

struct SolidChunk {
  ChunkPieces pieces;  ///< of the chunk's own triangles; which are open
  SolidCounts counts;
};

struct SolidChunkInput {
  const ChunkFacets& own;
  std::span<const FacetRecord> border;  ///< of earlier chunks, any order
  PointRank first = 0;                  ///< of the chunk
  PointRank end = 0;
  /// At edges of the chunk's points where others are joined than the inside says; sorted.
  std::span<const TurnedPair> turned{};
};

/// Where the coordinates of points come from.
struct SolidPoints {
  const PointStoreFile& store;
  const CoordinateRange& range;  ///< of the cloud
  MemoryBudget& budget;
};

/// \pre Every facing is known. \throw IoError, BudgetError
SolidChunk examine_solid_chunk(const SolidChunkInput& input, const SolidPoints& points);

}  // namespace stream_recon
