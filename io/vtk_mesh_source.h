// The mesh of a legacy VTK file of type POLYDATA: see io/mesh_source.h.
//
// POLYGONS in the layout of versions before 5 (a count before the corners of each), which this
// program writes; lines and single vertices before them are stepped over. What stands behind the
// polygons is not read.
#pragma once

#include "io/mesh_source.h"

namespace stream_recon {

/// \throw InputError no such header; IoError
std::unique_ptr<MeshSource> open_vtk_mesh(const MeshSourceOptions& options);

}  // namespace stream_recon
