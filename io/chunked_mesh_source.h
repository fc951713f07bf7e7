// The mesh of a .pvtp, chunk by chunk, or of a single .vtp: see io/mesh_source.h.
//
// Vertices are told apart by GlobalPointId, and by Sheet where there is one; a mesh of one chunk
// may do without.
#pragma once

#include "io/mesh_source.h"

namespace stream_recon {

/// Looks at the head of every chunk. \throw InputError, IoError
std::unique_ptr<MeshSource> open_chunked_mesh(const std::string& path);

}  // namespace stream_recon
