// Makes one chunk of the surface from its facets, and counts its part of the whole.
//
// Guarantees: a chunk is a function of the facets and the chunk layout. Every vertex and edge of
// the surface is counted in one chunk, that of its lowest rank, whether or not facets of that chunk
// use it. Thread rule: make() is const and thread-safe. Memory: about 70 bytes a triangle,
// reserved. Cost: about 250 ns a triangle.
#pragma once

#include <cstdint>
#include <span>

#include "engine/order/point_store.h"
#include "engine/stage_context.h"
#include "engine/surface/chunk_facets.h"
#include "engine/surface/facet_export.h"
#include "engine/surface/surface_counts.h"
#include "engine/surface/surface_sheets.h"
#include "engine/surface/vertex_numbering.h"
#include "io/surface_writer.h"

namespace stream_recon {

struct ChunkSurface {
  Reservation memory;    ///< for the chunk, and for its writer
  SurfaceChunk chunk;    ///< with vertex numbers if there is a numbering
  SurfaceCounts counts;  ///< before it is split
};

class ChunkSurfaceMaker {
 public:
  /// All outlive the maker.
  struct Parts {
    const ExportedFacets& surface;
    const VertexNumbering* numbering = nullptr;  ///< null: vertices need no numbers
    const SurfaceSheets* sheets = nullptr;       ///< null: the surface is not split
  };

  /// \throw IoError
  ChunkSurfaceMaker(const Parts& parts, const StageContext& context)
      : surface_(parts.surface),
        numbering_(parts.numbering),
        sheets_(parts.sheets),
        context_(context),
        store_(context.scratch.open(kPointStore)) {}

  /// \throw IoError, BudgetError, Interrupted
  ChunkSurface make(std::uint64_t chunk) const;

  /// What make() may be expected to need, bytes.
  static std::uint64_t typical_memory(std::uint64_t triangles);

 private:
  ChunkFacets read_facets(std::uint64_t chunk) const;
  void count_edges(std::uint64_t chunk, const ChunkFacets& facets, std::span<const EdgeUse> uses,
                   SurfaceCounts& counts) const;
  std::uint64_t count_vertices(std::uint64_t chunk, const ChunkFacets& facets) const;

  const ExportedFacets& surface_;
  const VertexNumbering* numbering_;
  const SurfaceSheets* sheets_;
  const StageContext& context_;
  PointStoreFile store_;
};

}  // namespace stream_recon
