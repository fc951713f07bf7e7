// A surface as one legacy VTK file: binary (big endian) POLYDATA, docs/formats.md.
//
// Points, triangles and their data stand apart in the file with their counts first: all are spooled
// to scratch until finish().
#pragma once

#include <memory>

#include "io/surface_writer.h"

namespace stream_recon {

/// \throw IoError cannot create
std::unique_ptr<SurfaceWriter> make_vtk_writer(const SurfaceWriterOptions& options);

}  // namespace stream_recon
