// A picture of meshes and clouds that are never loaded as a whole.
//
// The inputs are read twice, for the bounds and to be drawn into depth buffers; colours of
// components take one more pass.
// Guarantees: a function of the inputs and the options alone. Memory: a part of an input (see
// mesh_parts.h) and about 80 bytes a pixel, however large the inputs; for components 4 bytes a
// point of a mesh and 12 a component. Thread rule: stateless.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "tools/preview/background.h"
#include "tools/preview/coloring.h"
#include "tools/preview/picture.h"
#include "tools/preview/view.h"

namespace stream_recon {

struct PreviewInput {
  std::string path;  ///< what open_mesh_parts() opens
  Coloring coloring;
};

struct PreviewOptions {
  std::size_t width = 1200;                   ///< pixels, 1 to 16384
  std::size_t height = 900;                   ///< pixels, 1 to 16384
  std::vector<NamedView> views{NamedView{}};  ///< side by side
  Background background{};
  bool has_legend = true;  ///< where colours mean something and there is room
  double point_size = 0;   ///< diameter of points without faces, pixels; 0: as their density asks
};

/// \throw InputError, also where there is nothing to draw; IoError
/// \throw std::invalid_argument sizes, or a colouring the input has no data for
Picture draw_preview(const std::vector<PreviewInput>& inputs, const PreviewOptions& options);

}  // namespace stream_recon
