// A surface as one PLY file or stream: binary little endian, docs/formats.md.
//
// Vertices and faces arrive together but stand apart in the file, and their counts stand first:
// both are spooled to scratch until finish(). Unused points do not occur.
#pragma once

#include <memory>

#include "io/surface_writer.h"

namespace stream_recon {

/// \throw IoError cannot create
std::unique_ptr<SurfaceWriter> make_ply_writer(const SurfaceWriterOptions& options);

}  // namespace stream_recon
