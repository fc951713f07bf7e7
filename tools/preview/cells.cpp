#include "tools/preview/cells.h"

#include "tools/preview/plane_fit.h"

namespace stream_recon {

Cells::Cells(const DepthBuffer& buffer)
    : width_(buffer.width() / 2),
      height_(buffer.height() / 2),
      depths_(width_ * height_),
      normals_(width_ * height_) {
  std::vector<std::size_t> points;
  for (std::size_t y = 0; y < height_; ++y) {
    for (std::size_t x = 0; x < width_; ++x) {
      if (!take_nearest(buffer, x, y)) points.push_back(y * width_ + x);
    }
  }
  const PlaneFit fit(*this);
  for (const std::size_t at : points) normals_[at] = fit.normal(at % width_, at / width_);
}

bool Cells::take_nearest(const DepthBuffer& buffer, std::size_t x, std::size_t y) {
  std::size_t nearest_x = 2 * x;
  std::size_t nearest_y = 2 * y;
  for (const std::size_t sy : {2 * y, 2 * y + 1}) {
    for (const std::size_t sx : {2 * x, 2 * x + 1}) {
      if (buffer.depth(sx, sy) <= buffer.depth(nearest_x, nearest_y)) continue;
      nearest_x = sx;
      nearest_y = sy;
    }
  }
  depths_[y * width_ + x] = buffer.depth(nearest_x, nearest_y) / 2;
  normals_[y * width_ + x] = buffer.normal(nearest_x, nearest_y);
  return buffer.has_normal(nearest_x, nearest_y);
}

}  // namespace stream_recon
