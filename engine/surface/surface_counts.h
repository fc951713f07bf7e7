// What is counted of a surface, or of the part of it that one chunk answers for.
//
// Guarantees: the counts of parts add up. Thread rule: values. Memory: 1.5 KB.
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <span>

#include "engine/report.h"
#include "io/surface_writer.h"
#include "spatial/simplex_digest.h"

namespace stream_recon {

/// Above it a fill may span a gap that is one of the body, not of the samples.
inline constexpr float kDoubtfulClosure = 4;

struct SurfaceCounts {
  std::uint64_t vertices = 0;
  std::uint64_t edges = 0;
  std::uint64_t triangles = 0;
  std::uint64_t boundary_edges = 0;     ///< edges of one triangle
  std::uint64_t nonmanifold_edges = 0;  ///< edges of three and more
  SimplexDigest digest;                 ///< of the triangles' input indices
  DeltaHistogram delta_histogram{};
  std::uint64_t doubtful_fills = 0;  ///< fills of a closure above kDoubtfulClosure
  // Of solids only:
  std::uint64_t unpaired_uses = 0;  ///< triangles without a partner at an edge, once an edge
  std::uint64_t fans = 0;           ///< of triangles around vertices

  void merge(const SurfaceCounts& part) {
    vertices += part.vertices;
    edges += part.edges;
    triangles += part.triangles;
    boundary_edges += part.boundary_edges;
    nonmanifold_edges += part.nonmanifold_edges;
    doubtful_fills += part.doubtful_fills;
    unpaired_uses += part.unpaired_uses;
    fans += part.fans;
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

  /// Counts fills of a doubtful closure. \param closures of each triangle
  void add_closures(std::span<const float> closures, std::span<const TriangleSource> sources) {
    for (std::size_t t = 0; t < closures.size(); ++t) {
      const bool is_fill = sources[t] == TriangleSource::kFill;
      doubtful_fills += is_fill && closures[t] > kDoubtfulClosure ? 1 : 0;
    }
  }

  /// Vertices - edges + triangles.
  std::int64_t euler() const {
    return static_cast<std::int64_t>(vertices) - static_cast<std::int64_t>(edges) +
           static_cast<std::int64_t>(triangles);
  }
};

/// What is known of the whole surface.
struct SurfaceFacts {
  SurfaceCounts counts;
  std::uint64_t samples = 0;     ///< that are vertices, each once even where it is split
  std::uint64_t components = 0;  ///< edge-connected pieces that are no cavities
  std::uint64_t cavities = 0;    ///< closed pieces that face inward; of solids only
  double area = 0;
  // Of closed solids only:
  std::optional<double> volume;
  std::optional<std::int64_t> genus;
};

}  // namespace stream_recon
