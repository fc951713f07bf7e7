// Surfaces for the writers' tests, and what must come out of them.
#pragma once

#include <cstdint>
#include <map>
#include <random>
#include <vector>

#include "io/surface_writer.h"

namespace stream_recon {

/// Chunks that share points at their borders, as windows make them. Coordinates are float32 values
/// where asked, ids are large and out of order.
inline std::vector<SurfaceChunk> make_surface(std::size_t chunks, std::size_t triangles,
                                              Scalar scalar, unsigned seed) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> coordinate(-1e3, 1e3);
  std::uniform_real_distribution<float> coordinate32(-1e3F, 1e3F);
  const std::size_t point_count = chunks * triangles / 2 + 3;
  std::vector<Point3> points(point_count);
  std::vector<std::uint64_t> ids(point_count);
  for (std::size_t i = 0; i < point_count; ++i) {
    // Drawn as floats, not rounded to them: GCC 12 (-O2) drops the double -> float -> double of a
    // pair it stores as a vector.
    points[i] = scalar == Scalar::kFloat32
                    ? Point3{coordinate32(random), coordinate32(random), coordinate32(random)}
                    : Point3{coordinate(random), coordinate(random), coordinate(random)};
    ids[i] = (random() >> 20) * point_count + i;
  }
  std::vector<SurfaceChunk> surface(chunks);
  std::map<std::size_t, std::uint64_t> numbers;
  for (SurfaceChunk& chunk : surface) {
    std::map<std::size_t, std::uint32_t> positions;
    for (std::size_t t = 0; t < triangles; ++t) {
      auto& corners = chunk.triangles.emplace_back();
      for (std::uint32_t& corner : corners) {
        const std::size_t point = random() % point_count;
        const auto [entry, is_new] =
            positions.try_emplace(point, static_cast<std::uint32_t>(chunk.points.size()));
        corner = entry->second;
        if (!is_new) continue;
        chunk.points.push_back(points[point]);
        chunk.global_ids.push_back(ids[point]);
        chunk.vertex_numbers.push_back(numbers.try_emplace(point, numbers.size()).first->second);
      }
      chunk.delta.push_back(static_cast<float>(random() % 9000) / 100);
      chunk.closure.push_back(static_cast<float>(random() % 900) / 100);
      chunk.source.push_back(random() % 2 == 0 ? TriangleSource::kGamma : TriangleSource::kAlpha);
    }
  }
  return surface;
}

/// Writes all chunks to `options.path`; the bytes the writer counted.
inline std::uint64_t write_surface(const std::vector<SurfaceChunk>& surface,
                                   const SurfaceWriterOptions& options) {
  const auto writer = make_surface_writer(options);
  for (std::uint64_t i = 0; i < surface.size(); ++i) writer->write(i, surface[i]);
  writer->finish();
  return writer->bytes_written();
}

}  // namespace stream_recon
