// The pieces of one chunk: its triangles as far as they hang together within it.
//
// Guarantees: pieces that reach other chunks come first, numbered in the order of what is told of
// them; all is a function of the surface and the chunk layout. Thread rule: values and pure
// functions. Memory: 4 bytes a triangle, 32 a use of an edge that other chunks have too, 24 a
// piece of a solid.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/surface/chunk_facets.h"
#include "engine/surface/edge_census.h"
#include "engine/surface/edge_uses.h"
#include "engine/surface/shared_edge.h"
#include "spatial/double_double.h"

namespace stream_recon {

/// What decides whether a piece is the outside of a body or a cavity.
struct PieceFacts {
  DoubleDouble volume;   ///< six times what its triangles add to it
  bool is_open = false;  ///< a triangle lacks its partner at an edge
};

struct ChunkPieces {
  std::vector<std::uint32_t> of_triangle;  ///< the number of each triangle's piece
  std::uint32_t count = 0;
  std::uint32_t reaching = 0;     ///< how many may reach other chunks: the first
  std::vector<SharedEdge> told;   ///< of their edges
  std::vector<PieceFacts> facts;  ///< of each piece, of solids only
};

/// Numbers the pieces.
/// \param roots of the triangles: the lowest triangle of the piece of each
/// \param shared uses of edges that other chunks have too, by the chunk's triangles
ChunkPieces number_pieces(std::vector<std::uint32_t> roots, std::span<const EdgeUse> shared);

/// The pieces of a surface that bounds no solid: what hangs together at edges, of however many
/// triangles. \param two_sided the lowest triangle of what hangs together at edges of two
ChunkPieces pieces_at_edges(std::vector<std::uint32_t> two_sided, const ChunkFacets& facets,
                            const EdgeCensus::ChunkEdges& edges);

/// What is told of a triangle at an edge: its corners. \param use by the triangle
SharedEdge edge_of_use(const EdgeUse& use, const LocalTriangle& triangle,
                       std::span<const PointRank> ranks);

}  // namespace stream_recon
