// The position of each vertex in the vertex list of the whole surface: the order of first
// appearance, chunk by chunk and by rank within a chunk.
//
// Guarantees: numbers are 0, 1, ..., each vertex has one, whichever chunks it appears
// in; they depend on the facets and the chunk layout only.
// Thread rule: made by one thread, on all threads; then const and thread-safe.
// Memory: two spools, 8 bytes a chunk, and while it is made 40 bytes a facet of a chunk a thread.
// A point of one chunk may first appear in an earlier one, so numbers travel between chunks, on
// disk: what a chunk's neighbours must be told is found first, then the numbers are handed out.
#pragma once

#include <cstdint>
#include <span>
#include <tuple>
#include <vector>

#include "engine/chunks/chunk_spool.h"
#include "engine/stage_context.h"
#include "engine/surface/facet_export.h"
#include "engine/surface/surface_sheets.h"

namespace stream_recon {

class VertexNumbering {
 public:
  /// \param sheets null: the surface is not split; else vertices are keys of sheets, not ranks
  /// \throw IoError, BudgetError, Interrupted
  VertexNumbering(const ExportedFacets& surface, const SurfaceSheets* sheets,
                  const StageContext& context);

  /// \param vertices all that the chunk's facets have, ascending \throw IoError, BudgetError
  std::vector<std::uint64_t> numbers_of(std::uint64_t chunk,
                                        std::span<const PointRank> vertices) const;

 private:
  /// `chunk` uses a point that first appears where this is kept, or is told here by another.
  struct Share {
    PointRank rank = 0;
    std::uint64_t chunk = 0;

    friend bool operator==(const Share&, const Share&) = default;
    friend bool operator<(const Share& a, const Share& b) {
      return std::tie(a.rank, a.chunk) < std::tie(b.rank, b.chunk);
    }
  };
  struct Known {
    PointRank rank = 0;
    std::uint64_t number = 0;

    friend bool operator==(const Known&, const Known&) = default;
    friend bool operator<(const Known& a, const Known& b) {
      return std::tie(a.rank, a.number) < std::tie(b.rank, b.number);
    }
  };

  /// What numbers a chunk has to hand out.
  struct ChunkNeeds {
    Reservation memory;
    std::vector<PointRank> vertices;
    std::vector<Share> shares;
  };

  void find_shares(const ExportedFacets& surface, ChunkSpool<Share>& shares);
  std::vector<BorderPoint> border_points(const ExportedFacets& surface, std::uint64_t owner) const;
  void hand_out(const ExportedFacets& surface, const ChunkSpool<Share>& shares);
  ChunkNeeds find_needs(std::uint64_t chunk, const ExportedFacets& surface,
                        const ChunkSpool<Share>& shares) const;
  void hand_out(std::uint64_t chunk, const ChunkNeeds& needs);

  const SurfaceSheets* sheets_;
  const StageContext& context_;
  Reservation memory_;
  ChunkSpool<Known> known_;
  std::uint64_t vertex_count_ = 0;
  std::vector<std::uint64_t> first_numbers_;  ///< that each chunk hands out
};

}  // namespace stream_recon
