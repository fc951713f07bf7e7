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
  std::vector<std::uint64_t> global_ids;                ///< point data GlobalPointId
};

/// Reads the file `path`, "-" for standard input. \throw InputError, IoError
VtpMesh read_vtp_mesh(const std::string& path);

}  // namespace stream_recon
