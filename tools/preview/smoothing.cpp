#include "tools/preview/smoothing.h"

#include <algorithm>
#include <cmath>

namespace stream_recon {
namespace {

constexpr float kSpread = 0.0026F;  // standard deviation, of the screen's shorter side
constexpr float kDepthSpread = 3;   // of the standard deviation

class NormalFilter {
 public:
  explicit NormalFilter(const Cells& cells)
      : cells_(cells), spread_(std::max(0.7F, kSpread * cells.shorter_side())) {
    radius_ = static_cast<std::ptrdiff_t>(std::ceil(2 * spread_));
    for (std::ptrdiff_t d = -radius_; d <= radius_; ++d) {
      const float t = static_cast<float>(d) / spread_;
      weights_.push_back(std::exp(-t * t / 2));
    }
  }

  Vector3f at(std::size_t x, std::size_t y) const {
    const Range columns = around(x, cells_.width());
    const Range rows = around(y, cells_.height());
    Vector3f sum;
    for (std::size_t cy = rows.begin; cy < rows.end; ++cy) {
      for (std::size_t cx = columns.begin; cx < columns.end; ++cx) {
        if (cells_.is_empty(cx, cy)) continue;
        const float weight = weights_[cx + radius_ - x] * weights_[cy + radius_ - y] *
                             likeness(cells_.depth(cx, cy) - cells_.depth(x, y));
        const Vector3f& n = cells_.normal(cx, cy);
        sum = {sum.x + weight * n.x, sum.y + weight * n.y, sum.z + weight * n.z};
      }
    }
    const float length = std::sqrt(sum.x * sum.x + sum.y * sum.y + sum.z * sum.z);
    if (length == 0) return cells_.normal(x, y);
    return {sum.x / length, sum.y / length, sum.z / length};
  }

 private:
  struct Range {
    std::size_t begin;
    std::size_t end;
  };
  Range around(std::size_t at, std::size_t size) const {
    const auto i = static_cast<std::ptrdiff_t>(at);
    return {static_cast<std::size_t>(std::max<std::ptrdiff_t>(0, i - radius_)),
            std::min(size, static_cast<std::size_t>(i + radius_ + 1))};
  }
  float likeness(float depth_difference) const {
    const float t = depth_difference / (kDepthSpread * spread_);
    return 1 / (1 + t * t * t * t);
  }

  const Cells& cells_;
  float spread_;
  std::ptrdiff_t radius_ = 0;
  std::vector<float> weights_;
};

}  // namespace

std::vector<Vector3f> smooth_normals(const Cells& cells) {
  const NormalFilter filter(cells);
  std::vector<Vector3f> normals;
  normals.reserve(cells.width() * cells.height());
  for (std::size_t y = 0; y < cells.height(); ++y) {
    for (std::size_t x = 0; x < cells.width(); ++x)
      normals.push_back(cells.is_empty(x, y) ? Vector3f{} : filter.at(x, y));
  }
  return normals;
}

}  // namespace stream_recon
