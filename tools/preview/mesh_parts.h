// A mesh or a cloud on disk, part by part, as often as one likes.
//
// Guarantees: each triangle comes once, in the order of the file, with its corners among the
// points of its part; global_ids number the points of the whole where the file tells (Delta,
// Source and Closure likewise). A part without triangles is points to be seen by themselves.
// Memory: a chunk of a .pvtp, the whole of a .vtp, else 16 MB. Thread rule: one thread.
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "io/vtp_mesh_reader.h"

namespace stream_recon {

class MeshParts {
 public:
  virtual ~MeshParts() = default;
  /// \throw InputError, IoError
  virtual void for_each(const std::function<void(const VtpMesh&)>& visit) = 0;
};

/// .pvtp, .vtp, binary .ply with faces, binary legacy .vtk with polygons; else a cloud in any
/// format of io/point_source.h. \throw InputError not readable so; IoError
std::unique_ptr<MeshParts> open_mesh_parts(const std::string& path);

/// Those of single files; nothing where the file has no faces.
std::unique_ptr<MeshParts> open_ply_faces(const std::string& path);
std::unique_ptr<MeshParts> open_vtk_faces(const std::string& path);

}  // namespace stream_recon
