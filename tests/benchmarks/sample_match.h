// How many samples of a cloud are vertices of a mesh, and how many vertices are no samples.
//
// Points match if their coordinates are equal. Thread rule: one thread. Memory: 24 bytes a point of
// the cloud and of the mesh.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "spatial/point.h"

namespace stream_recon {

struct SampleMatch {
  std::uint64_t samples = 0;         ///< different ones
  std::uint64_t matched = 0;         ///< of those, vertices of the mesh
  std::uint64_t added_vertices = 0;  ///< different ones that are no samples
};

inline SampleMatch match_samples(std::vector<Point3> samples, std::vector<Point3> vertices) {
  for (std::vector<Point3>* points : {&samples, &vertices}) {
    std::sort(points->begin(), points->end());
    points->erase(std::unique(points->begin(), points->end()), points->end());
  }
  SampleMatch match{.samples = samples.size()};
  match.matched = static_cast<std::uint64_t>(
      std::count_if(samples.begin(), samples.end(), [&vertices](const Point3& p) {
        return std::binary_search(vertices.begin(), vertices.end(), p);
      }));
  match.added_vertices = vertices.size() - match.matched;
  return match;
}

}  // namespace stream_recon
