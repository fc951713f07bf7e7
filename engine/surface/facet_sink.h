// Where the windows put the facets of the surface: sorted into chunks, on disk.
//
// Guarantees: after finish(), facets has exactly the facets of each chunk; border_points and
// border_edges have the points and edges of each chunk that facets of earlier chunks use, once a
// use. Thread rule: add() is thread-safe; the rest belongs to one thread.
// Memory: the buffers of three spools (chunk_spool.h).
#pragma once

#include <mutex>
#include <span>
#include <tuple>

#include "engine/surface/chunk_layout.h"
#include "engine/surface/chunk_spool.h"
#include "engine/surface/edge_census.h"
#include "engine/surface/facet_record.h"

namespace stream_recon {

/// A point that a facet of the earlier chunk `user` has as a vertex.
struct BorderPoint {
  PointRank rank = 0;
  std::uint64_t user = 0;

  friend bool operator==(const BorderPoint&, const BorderPoint&) = default;
  friend bool operator<(const BorderPoint& a, const BorderPoint& b) {
    return std::tie(a.rank, a.user) < std::tie(b.rank, b.user);
  }
};

class FacetSink {
 public:
  FacetSink(const ChunkLayout& layout, const SpoolOptions& options)
      : layout_(layout),
        facets_("facets", layout.chunk_count(), options),
        border_points_("border_points", layout.chunk_count(), options),
        border_edges_("border_edges", layout.chunk_count(), options) {}

  /// Memory until finish(), bytes.
  static std::uint64_t memory(const ChunkLayout& layout) {
    return 3 * spool_memory(layout.chunk_count());
  }

  /// \throw IoError
  void add(std::span<const FacetRecord> facets);
  /// \throw IoError
  void finish();

  const ChunkLayout& layout() const { return layout_; }
  const ChunkSpool<FacetRecord>& facets() const { return facets_; }
  const ChunkSpool<BorderPoint>& border_points() const { return border_points_; }
  const ChunkSpool<BorderEdge>& border_edges() const { return border_edges_; }

 private:
  ChunkLayout layout_;
  std::mutex mutex_;
  ChunkSpool<FacetRecord> facets_;
  ChunkSpool<BorderPoint> border_points_;
  ChunkSpool<BorderEdge> border_edges_;
};

}  // namespace stream_recon
