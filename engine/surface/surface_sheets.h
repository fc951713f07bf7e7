// The sheets of the whole surface: which vertices are split, and into what.
//
// A chunk finds the sheets of the vertices it owns; the corners of their triangles, and who uses
// which sheet, travel to the chunks of the triangles on disk. Vertices that must know what the far
// ends of their edges found wait for a second pass over what is left.
// Guarantees: a function of the facets and the chunk layout, whatever the threads and the memory.
// Thread rule: made by one thread, on all threads; then const and thread-safe.
// Memory, from the budget: five spools of 3 MB (4 KB a chunk where that is more), and
// SheetSearch::typical_memory() a thread, while it is made; then what spools keep. Disk: 32 bytes
// for each triangle at a vertex of several sheets, before compression. Cost: SheetSearch's.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/chunks/chunk_spool.h"
#include "engine/stage_context.h"
#include "engine/surface/facet_export.h"
#include "engine/surface/sheet_records.h"
#include "engine/surface/sheet_search.h"
#include "engine/surface/surface_counts.h"

namespace stream_recon {

class SurfaceSheets {
 public:
  /// The most points a cloud may have: ranks take 32 bits.
  static constexpr std::uint64_t kMostPoints = (std::uint64_t{1} << 32) - 2;

  /// \param surface closed, exported by export_solid_facets()
  /// \throw InputError too many points; IoError, BudgetError, Interrupted; std::logic_error not
  /// closed
  SurfaceSheets(const ExportedFacets& surface, const StageContext& context);

  /// Of the triangles of a chunk, sorted; the caller reserves corner_count() of them. Tells of all
  /// corners at the vertices that are split. \throw IoError, BudgetError
  std::vector<SheetCorner> corners(std::uint64_t chunk) const;
  std::uint64_t corner_count(std::uint64_t chunk) const { return corners_.count(chunk); }

  /// At the edges of the chunk's points, sorted; the caller reserves turned_count() of them.
  /// \throw IoError, BudgetError
  std::vector<TurnedPair> turned_pairs(std::uint64_t chunk) const;
  std::uint64_t turned_count(std::uint64_t chunk) const { return turned_.count(chunk); }

  /// As ExportedFacets::border_points() of a chunk, with keys of sheets in place of ranks, some
  /// repeated; the caller reserves border_count(). \throw IoError, BudgetError
  std::vector<BorderPoint> border_points(std::uint64_t chunk) const;
  std::uint64_t border_count(std::uint64_t chunk) const {
    return surface_.border_points().count(chunk) + uses_.count(chunk);
  }

  /// Makes the counts of the surface those of the split one.
  /// \throw std::logic_error it is no manifold
  void correct(SurfaceCounts& counts) const;

 private:
  void find();
  void part();
  void take(std::uint64_t chunk, const FoundSheets& found);
  void take_corners(std::uint64_t chunk, const FoundSheets& found);

  const ExportedFacets& surface_;
  const StageContext& context_;
  SheetSearch search_;
  ChunkSpool<StarTriangle> open_;
  ChunkSpool<SheetTouch> touches_;
  ChunkSpool<SheetCorner> corners_;
  ChunkSpool<TurnedPair> turned_;
  ChunkSpool<BorderPoint> uses_;  ///< of split vertices by other chunks than theirs: keys
  SheetCounts counts_;
};

}  // namespace stream_recon
