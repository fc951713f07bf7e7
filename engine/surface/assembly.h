// From facets in chunks to the surface: one pass over the chunks, several at once.
//
// Guarantees: the chunks handed to the writer are functions of the facets and the chunk layout,
// not of the order in which the facets came, the memory or the threads. Counts and sums are those
// of the whole surface. Chunks without triangles are not written. The triangles of a solid face
// outward.
// Thread rule: one caller; works on all threads that the memory allows. Memory: a chunk a thread,
// about 70 bytes a triangle, of a solid 110, and 6 MB each; that of surface/piece_join.h.
#pragma once

#include "engine/stage_context.h"
#include "engine/surface/facet_export.h"
#include "engine/surface/surface_counts.h"
#include "io/points_writer.h"
#include "io/surface_writer.h"
#include "spatial/coordinate_range.h"

namespace stream_recon {

struct AssemblyOptions {
  /// Whether the facets bound a solid: all know their facing and closure, and were exported by
  /// export_solid_facets().
  bool is_solid = false;
  /// Split the surface of a closed solid into sheets (surface/surface_sheets.h), which makes it a
  /// manifold: the writer gets vertices once for each sheet, with the sheets' numbers.
  bool splits = false;
  CoordinateRange range;           ///< of the cloud
  PointsWriter* unused = nullptr;  ///< gets the points that no triangle has, if given
};

/// \throw IoError, BudgetError, Interrupted
SurfaceFacts assemble_surface(const ExportedFacets& surface, SurfaceWriter& writer,
                              const StageContext& context, const AssemblyOptions& options);

}  // namespace stream_recon
