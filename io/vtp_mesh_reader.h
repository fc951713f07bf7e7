// A chunk of a surface (.vtp) as a whole: triangles, their points and what is known of them.
//
// Guarantees: every corner of a triangle is a point; arrays that are there have the length of what
// they describe, arrays that are not there are empty. Pieces are joined in their order; vertices
// and lines are left out, strips and polygons of other than three corners refused.
// Memory: the chunk. Cost: that of the decompression. Thread rule: stateless.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "spatial/point.h"

namespace stream_recon {

struct VtpMesh {
  std::vector<Point3> points;
  std::vector<std::array<std::uint32_t, 3>> triangles;  ///< positions in `points`
  std::vector<float> delta;                             ///< cell data Delta of the triangles
  std::vector<std::uint8_t> source;                     ///< cell data Source of the triangles
  std::vector<float> closure;                           ///< cell data Closure of the triangles
  std::vector<std::uint64_t> global_ids;                ///< point data PoleId, else GlobalPointId
  std::vector<std::uint32_t> sheets;                    ///< point data Sheet
};

/// Reads the file `path`, "-" for standard input. \throw InputError, IoError
VtpMesh read_vtp_mesh(const std::string& path);

/// What the head of a file promises.
struct VtpMeshSize {
  std::uint64_t points = 0;
  std::uint64_t triangles = 0;
  bool has_global_ids = false;

  /// What read_vtp_mesh() holds at most, bytes.
  std::uint64_t memory_bytes() const { return 80 * points + 76 * triangles; }
};

/// Reads no more than the XML where the arrays are appended. \throw InputError, IoError
VtpMeshSize read_vtp_mesh_size(const std::string& path);

}  // namespace stream_recon
