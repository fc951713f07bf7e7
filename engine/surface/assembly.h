// From facets in chunks to the surface: one pass over the chunks, several at once.
//
// Guarantees: the chunks handed to the writer are functions of the facets and the chunk layout,
// not of the order in which the facets came, the memory or the threads. Counts are those of the
// whole surface. Chunks without triangles are not written.
// Thread rule: one caller; works on all threads that the memory allows. Memory: a chunk a thread,
// about 70 bytes a triangle and 6 MB each.
#pragma once

#include "engine/stage_context.h"
#include "engine/surface/facet_export.h"
#include "engine/surface/surface_counts.h"
#include "io/surface_writer.h"

namespace stream_recon {

struct AssemblyOptions {
  /// Split the surface into sheets (surface/surface_sheets.h), which makes it a manifold: the
  /// writer gets vertices once for each sheet, with the sheets' numbers.
  bool splits = false;
};

/// \throw IoError, BudgetError, Interrupted
SurfaceCounts assemble_surface(const ExportedFacets& surface, SurfaceWriter& writer,
                               const StageContext& context, const AssemblyOptions& options = {});

}  // namespace stream_recon
