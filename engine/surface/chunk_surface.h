// Makes one chunk of the surface from its facets, and counts its part of the whole.
//
// Guarantees: a chunk is a function of the facets and the chunk layout. Every vertex and edge of
// the surface is counted in one chunk, that of its lowest rank, whether or not facets of that chunk
// use it. Thread rule: make() is const and thread-safe. Memory: about 70 bytes a triangle, of a
// solid 110, reserved. Cost: about 250 ns a triangle, of a solid 500.
#pragma once

#include <cstdint>
#include <span>

#include "engine/order/point_store.h"
#include "engine/stage_context.h"
#include "engine/surface/assembly.h"
#include "engine/surface/chunk_facets.h"
#include "engine/surface/chunk_pieces.h"
#include "engine/surface/facet_export.h"
#include "engine/surface/piece_join.h"
#include "engine/surface/surface_counts.h"
#include "engine/surface/surface_sheets.h"
#include "engine/surface/vertex_numbering.h"
#include "io/surface_writer.h"

namespace stream_recon {

struct ChunkSurface {
  Reservation memory;    ///< for the chunk, and for its writer
  SurfaceChunk chunk;    ///< with vertex numbers if there is a numbering
  SurfaceCounts counts;  ///< before it is split
  ChunkPieces pieces;
  ChunkSums sums;
  std::vector<Point3> unused;  ///< points of the chunk that no triangle has, if asked for
};

class ChunkSurfaceMaker {
 public:
  struct Input {
    const ExportedFacets& surface;
    const VertexNumbering* numbering = nullptr;  ///< null: vertices need no numbers
    const SurfaceSheets* sheets = nullptr;       ///< null: the surface is not split
    const AssemblyOptions& options;
  };

  /// \pre All parts of the input outlive the maker. \throw IoError
  ChunkSurfaceMaker(const Input& input, const StageContext& context)
      : surface_(input.surface),
        numbering_(input.numbering),
        sheets_(input.sheets),
        options_(input.options),
        context_(context),
        scale_(input.options.range.scale().value_or(1)),
        store_(context.scratch.open(input.surface.point_store())) {}

  /// \throw IoError, BudgetError, Interrupted
  ChunkSurface make(std::uint64_t chunk) const;

  /// What make() may be expected to need, bytes.
  std::uint64_t typical_memory(std::uint64_t triangles) const;

 private:
  /// Bytes for so many triangles and vertices.
  std::uint64_t working_memory(std::uint64_t triangles, std::uint64_t vertices) const;
  std::uint64_t output_memory(std::uint64_t triangles, std::uint64_t vertices) const;

  ChunkFacets read_facets(std::uint64_t chunk) const;
  std::vector<PointRank> border_ranks(std::uint64_t chunk) const;
  /// Counts and orients a surface that bounds no solid, finds its pieces.
  std::vector<bool> examine_open(std::uint64_t chunk, const ChunkFacets& facets,
                                 ChunkSurface& result) const;
  /// The same of a solid.
  std::vector<bool> examine_solid(std::uint64_t chunk, const ChunkFacets& facets,
                                  ChunkSurface& result) const;
  void measure(ChunkSurface& result) const;
  void find_unused(std::uint64_t chunk, std::span<const PointRank> vertices,
                   ChunkSurface& result) const;

  const ExportedFacets& surface_;
  const VertexNumbering* numbering_;
  const SurfaceSheets* sheets_;
  const AssemblyOptions& options_;
  const StageContext& context_;
  const double scale_;  ///< of coordinates, for sums that neither overflow nor vanish
  PointStoreFile store_;
};

}  // namespace stream_recon
