// The mesh of a PLY file, in any of the three PLY formats: see io/mesh_source.h.
//
// The vertices come before the faces, as in every file met so far; other elements and properties
// are stepped over. Faces are triangles: the list `vertex_indices` (or `vertex_index`) has
// length 3.
#pragma once

#include "io/mesh_source.h"

namespace stream_recon {

/// \throw InputError no such header; IoError
std::unique_ptr<MeshSource> open_ply_mesh(const MeshSourceOptions& options);

}  // namespace stream_recon
