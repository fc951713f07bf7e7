// What is counted of a surface, or of the part of it that one chunk answers for.
//
// Guarantees: the counts of parts add up. Thread rule: a value. Memory: 1.5 KB.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>

#include "engine/report.h"
#include "spatial/simplex_digest.h"

namespace stream_recon {

struct SurfaceCounts {
  std::uint64_t vertices = 0;
  std::uint64_t edges = 0;
  std::uint64_t triangles = 0;
  std::uint64_t boundary_edges = 0;     ///< edges of one triangle
  std::uint64_t nonmanifold_edges = 0;  ///< edges of three and more
  SimplexDigest digest;                 ///< of the triangles' input indices
  DeltaHistogram delta_histogram{};

  void merge(const SurfaceCounts& part) {
    vertices += part.vertices;
    edges += part.edges;
    triangles += part.triangles;
    boundary_edges += part.boundary_edges;
    nonmanifold_edges += part.nonmanifold_edges;
    digest.merge(part.digest);
    for (std::size_t i = 0; i < delta_histogram.size(); ++i) {
      delta_histogram[i] += part.delta_histogram[i];
    }
  }

  /// Counts angles in degrees, 0 to 180.
  void add_deltas(std::span<const float> deltas) {
    for (const float delta : deltas) {
      const auto degree = static_cast<std::size_t>(std::clamp(delta, 0.0F, 179.0F));
      ++delta_histogram[degree];
    }
  }

  /// Vertices - edges + triangles.
  std::int64_t euler() const {
    return static_cast<std::int64_t>(vertices) - static_cast<std::int64_t>(edges) +
           static_cast<std::int64_t>(triangles);
  }
};

}  // namespace stream_recon
