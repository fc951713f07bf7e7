// The points of a surface that arrives in chunks, each point once.
//
// Memory: the points new in one chunk. Thread rule: one thread.
#pragma once

#include <cstdint>
#include <vector>

#include "io/surface_writer.h"

namespace stream_recon {

class SurfacePoints {
 public:
  /// Positions in `chunk` of the points that no chunk before had, ascending. Counts points and
  /// triangles.
  /// \throw IoError more vertices or triangles than `format`, with 32-bit numbers, can hold
  std::vector<std::uint32_t> take_new(const SurfaceChunk& chunk, const char* format);

  std::uint64_t vertices() const { return vertices_; }
  std::uint64_t triangles() const { return triangles_; }

 private:
  std::uint64_t vertices_ = 0;
  std::uint64_t triangles_ = 0;
};

}  // namespace stream_recon
