#include "io/surface_points.h"

#include <cassert>
#include <limits>
#include <string>

#include "io/error.h"

namespace stream_recon {

std::vector<std::uint32_t> SurfacePoints::take_new(const SurfaceChunk& chunk, const char* format) {
  std::vector<std::uint32_t> positions;
  for (std::size_t i = 0; i < chunk.points.size(); ++i) {
    if (chunk.vertex_numbers[i] < vertices_) continue;
    assert(chunk.vertex_numbers[i] == vertices_ + positions.size());
    positions.push_back(static_cast<std::uint32_t>(i));
  }
  vertices_ += positions.size();
  triangles_ += chunk.triangles.size();
  // Four numbers a triangle are the longest list a format counts in 32 bits.
  constexpr std::uint64_t kMost = std::numeric_limits<std::int32_t>::max();
  if (vertices_ > kMost || triangles_ > kMost / 4) {
    throw IoError("cannot write a surface of " + std::to_string(vertices_) + " vertices and " +
                  std::to_string(triangles_) + " triangles as " + format +
                  ", which counts in 32 bits; write OUT.pvtp");
  }
  return positions;
}

}  // namespace stream_recon
