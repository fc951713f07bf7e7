// A depth buffer at half its resolution: the nearest sample of each 2 x 2, lengths in cells.
//
// Points have no normals: theirs is that of the plane through the depths around, those about as far
// away as themselves. Memory: 16 bytes a cell, 8 more for points while it is made. Thread rule:
// const after construction.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "tools/preview/depth_buffer.h"

namespace stream_recon {

class Cells {
 public:
  explicit Cells(const DepthBuffer& buffer);

  std::size_t width() const { return width_; }
  std::size_t height() const { return height_; }
  float shorter_side() const { return static_cast<float>(std::min(width_, height_)); }
  /// DepthBuffer::kNothing where no sample has a surface.
  float depth(std::size_t x, std::size_t y) const { return depths_[y * width_ + x]; }
  const Vector3f& normal(std::size_t x, std::size_t y) const { return normals_[y * width_ + x]; }
  bool is_empty(std::size_t x, std::size_t y) const { return depth(x, y) == DepthBuffer::kNothing; }

 private:
  /// Whether the nearest sample has a normal.
  bool take_nearest(const DepthBuffer& buffer, std::size_t x, std::size_t y);

  std::size_t width_;
  std::size_t height_;
  std::vector<float> depths_;
  std::vector<Vector3f> normals_;
};

}  // namespace stream_recon
