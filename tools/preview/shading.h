// Turns a depth buffer into a picture: light, shade and background.
//
// A key light from the upper left, a cool fill light from the right, light from the sky weighed by
// how much of it a point sees, on a neutral gradient. Four samples make a pixel.
// Guarantees: a function of the depth buffer alone. Thread rule: stateless.
#pragma once

#include "tools/preview/depth_buffer.h"
#include "tools/preview/picture.h"

namespace stream_recon {

/// The picture has half the buffer's width and height.
Picture shade(const DepthBuffer& buffer);

}  // namespace stream_recon
