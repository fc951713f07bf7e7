// Turns a depth buffer into a picture: light, shade and background.
//
// A key light from the upper left, a cool fill light from the right, light from the sky weighed by
// how much of it a point sees. Four samples make a pixel.
// Points fade a little with their depth, since they have no edges that would tell it.
// Guarantees: a function of the depth buffer and the options alone. Thread rule: stateless.
#pragma once

#include <span>

#include "tools/preview/background.h"
#include "tools/preview/depth_buffer.h"
#include "tools/preview/picture.h"

namespace stream_recon {

struct ShadeOptions {
  std::span<const Color> palette;  ///< one for each paint of the buffer
  Background background;
};

/// The picture has half the buffer's width and height.
Picture shade(const DepthBuffer& buffer, const ShadeOptions& options);

}  // namespace stream_recon
