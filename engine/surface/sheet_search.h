// Finds the vertices of a chunk that have several sheets, and what each sheet consists of.
//
// Guarantees: find() and then part() tell of every such vertex of the chunk once: find() of those
// that need not ask other vertices, part() of the rest.
// Thread rule: const for many. Memory: that of VertexStars, 3 MB, 16 bytes for each record found,
// from the budget. Cost: find() about 150 ns a triangle, and 5 us for each vertex that is no fan.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/chunks/chunk_spool.h"
#include "engine/order/point_store.h"
#include "engine/stage_context.h"
#include "engine/surface/facet_export.h"
#include "engine/surface/sheet_records.h"
#include "engine/surface/vertex_sheets.h"

namespace stream_recon {

/// How splitting changes the counts of the surface.
struct SheetCounts {
  std::uint64_t added_vertices = 0;
  std::uint64_t added_edges = 0;
  std::uint64_t split_edges = 0;  ///< that have more than two triangles

  void merge(const SheetCounts& part) {
    added_vertices += part.added_vertices;
    added_edges += part.added_edges;
    split_edges += part.split_edges;
  }
};

struct FoundSheets {
  Reservation memory;
  std::vector<SheetCorner> corners;  ///< of the vertices with several sheets, vertex by vertex
  std::vector<StarTriangle> open;    ///< stars that wait for part()
  std::vector<SheetTouch> touches;   ///< for the chunks of their vertices
  std::vector<TurnedPair> turned;    ///< at edges of the chunk's vertices
  SheetCounts counts;
};

class SheetSearch {
 public:
  /// \pre `surface` and `context` outlive it; fewer than 2^32 points. \throw IoError
  SheetSearch(const ExportedFacets& surface, const StageContext& context)
      : surface_(surface), context_(context), store_(context.scratch.open(surface.point_store())) {}

  /// What find() may be expected to need for a chunk, bytes.
  static std::uint64_t typical_memory(std::uint64_t triangles, std::uint64_t points);

  /// \throw IoError, BudgetError, Interrupted
  FoundSheets find(std::uint64_t chunk) const;

  /// \param open stars of vertices of one chunk, one after the other
  /// \param touches for its vertices, sorted \throw IoError, BudgetError, Interrupted
  FoundSheets part(std::span<const StarTriangle> open, std::span<const SheetTouch> touches) const;

 private:
  const ExportedFacets& surface_;
  const StageContext& context_;
  PointStoreFile store_;
};

}  // namespace stream_recon
