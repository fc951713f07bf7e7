// A picture of a chunked mesh that is never loaded as a whole.
//
// The chunks are read twice: for the bounds, then to be drawn into a depth buffer.
// Guarantees: a function of the mesh and the options alone. Memory: one chunk and about 40 bytes a
// pixel, however large the mesh. Thread rule: stateless.
#pragma once

#include <cstddef>
#include <string>

#include "tools/preview/picture.h"
#include "tools/preview/view.h"

namespace stream_recon {

struct PreviewOptions {
  std::size_t width = 1200;  ///< pixels, 1 to 16384
  std::size_t height = 900;  ///< pixels, 1 to 16384
  View view;
};

/// Draws a .pvtp, or a single .vtp.
/// \throw InputError, also for a mesh without triangles; IoError; std::invalid_argument size
Picture draw_preview(const std::string& path, const PreviewOptions& options);

}  // namespace stream_recon
