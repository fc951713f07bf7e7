// From facets in chunks to the surface: one ascending pass over the chunks.
//
// Guarantees: the chunks handed to the writer are functions of the facets and the chunk layout,
// not of the order in which the facets came. Counts are those of the whole surface. Chunks without
// triangles are not written.
// Thread rule: one caller; sorts on all threads. Memory: one chunk, about 140 bytes a triangle.
#pragma once

#include <cstdint>

#include "engine/stage_context.h"
#include "engine/surface/facet_export.h"
#include "io/surface_writer.h"
#include "spatial/simplex_digest.h"

namespace stream_recon {

struct SurfaceCounts {
  std::uint64_t vertices = 0;
  std::uint64_t edges = 0;
  std::uint64_t triangles = 0;
  std::uint64_t boundary_edges = 0;     ///< edges of one triangle
  std::uint64_t nonmanifold_edges = 0;  ///< edges of three and more
  SimplexDigest digest;                 ///< of the triangles' input indices

  /// Vertices - edges + triangles.
  std::int64_t euler() const {
    return static_cast<std::int64_t>(vertices) - static_cast<std::int64_t>(edges) +
           static_cast<std::int64_t>(triangles);
  }
};

/// \throw IoError, BudgetError, Interrupted
SurfaceCounts assemble_surface(const ExportedFacets& surface, SurfaceWriter& writer,
                               const StageContext& context);

}  // namespace stream_recon
