// A stretch of the Hilbert curve whose tetrahedra are final, and who looks at it.
//
// Guarantees: every tetrahedron and facet whose vertex of lowest rank is owned belongs to the
// Delaunay tetrahedralization of the whole cloud, and so do the two cells of such a facet; these
// are what the window emits (windows/final_simplices.h). Other cells, with an owned vertex or
// without, promise nothing, unless a consumer asked for whole stars: then every cell with an owned
// vertex belongs to it. Windows own disjoint ranges of ranks that cover the cloud; they share
// nothing, so a consumer must not care in which order they come. Thread rule: a view, const access
// from many; it does not outlive what it looks at.
#pragma once

#include <cstdint>
#include <span>

#include "spatial/delaunay.h"

namespace stream_recon {

class ExportWriter;

/// Position of a point in the Hilbert order of the cloud, duplicates merged.
using PointRank = std::uint64_t;

class FinalWindow {
 public:
  struct Parts {
    const Delaunay* delaunay = nullptr;  ///< the owned points first, in rank order, then guests
    PointRank first_rank = 0;            ///< of the owned points
    std::uint64_t owned_count = 0;
    std::span<const PointRank> guest_ranks;        ///< of vertex owned_count, owned_count + 1, ...
    std::span<const std::uint64_t> input_indices;  ///< of every vertex
  };

  explicit FinalWindow(const Parts& parts) : parts_(parts) {}

  const Delaunay& delaunay() const { return *parts_.delaunay; }

  PointRank rank(VertexId v) const {
    return v < parts_.owned_count ? parts_.first_rank + v
                                  : parts_.guest_ranks[v - parts_.owned_count];
  }

  std::uint64_t input_index(VertexId v) const { return parts_.input_indices[v]; }

  /// The vertices below this one are owned.
  VertexId owned_count() const { return static_cast<VertexId>(parts_.owned_count); }
  bool owns_vertex(VertexId v) const { return v < parts_.owned_count; }

  /// The lowest rank that is owned.
  PointRank first_rank() const { return parts_.first_rank; }

  bool owns(PointRank rank) const {
    return rank >= parts_.first_rank && rank - parts_.first_rank < parts_.owned_count;
  }

 private:
  Parts parts_;
};

class WindowConsumer {
 public:
  virtual ~WindowConsumer() = default;
  /// Takes what the window emits and exports what later stages need of it; the window is dropped
  /// afterwards. Called from several threads at once, each with another window.
  virtual void consume(const FinalWindow& window, ExportWriter& out) = 0;
  /// What consume() allocates for this window at most, besides a megabyte, bytes.
  virtual std::uint64_t memory(const FinalWindow& /*window*/) const { return 0; }
};

}  // namespace stream_recon
