// Gives the triangles of a chunk a vertex of its own for each sheet.
//
// Thread rule: pure functions. Memory: 20 bytes a vertex, from the budget.
#pragma once

#include <span>
#include <vector>

#include "engine/budget.h"
#include "engine/surface/chunk_facets.h"
#include "engine/surface/surface_sheets.h"

namespace stream_recon {

/// The vertices that a chunk's triangles have once they are split, ascending.
/// \param ranks of the vertices, ascending \param corners of the chunk
std::vector<SheetKey> split_vertices(std::span<const PointRank> ranks,
                                     std::span<const SheetCorner> corners);

struct SplitFacets {
  Reservation memory;                 ///< for the keys, and for the copies' part of the facets
  std::vector<SheetKey> keys;         ///< of the vertices
  std::vector<std::uint32_t> sheets;  ///< of the vertices
};

/// Vertices are repeated, once for each sheet that the chunk uses; triangles keep their order and
/// ascend still. \param facets of the chunk \throw IoError, BudgetError
SplitFacets split_facets(const SurfaceSheets& sheets, std::uint64_t chunk, MemoryBudget& budget,
                         ChunkFacets& facets);

}  // namespace stream_recon
