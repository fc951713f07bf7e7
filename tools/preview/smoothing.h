// Normals smoothed on the screen, so that a mesh through voxels shades like the body it samples.
//
// Guarantees: only surfaces at about the same depth mix; a function of the cells alone.
// Memory: 12 bytes a cell. Source: Tomasi, Manduchi, ICCV 1998 (bilateral filter).
#pragma once

#include <vector>

#include "tools/preview/cells.h"

namespace stream_recon {

/// Unit normals, row by row from below; those of empty cells mean nothing.
std::vector<Vector3f> smooth_normals(const Cells& cells);

}  // namespace stream_recon
