#include "tools/preview/projection.h"

#include <algorithm>
#include <cmath>

namespace stream_recon {
namespace {

constexpr double kMargin = 0.06;  // of the screen's sides

double middle(double low, double high) {
  return low / 2 + high / 2;
}

}  // namespace

Projection::Projection(const Box3& box, const DepthBuffer& screen)
    : center_{middle(box.low.x, box.high.x), middle(box.low.y, box.high.y),
              middle(box.low.z, box.high.z)},
      half_width_(static_cast<double>(screen.width()) / 2),
      half_height_(static_cast<double>(screen.height()) / 2) {
  const double wide = std::max(box.high.x - box.low.x, box.extent() * 1e-6);
  const double high = std::max(box.high.y - box.low.y, box.extent() * 1e-6);
  scale_ = (1 - 2 * kMargin) * 2 * std::min(half_width_ / wide, half_height_ / high);
  if (!std::isfinite(scale_)) scale_ = 1;
}

Vector3f Projection::operator()(const Point3& p) const {
  return {static_cast<float>((p.x - center_.x) * scale_ + half_width_),
          static_cast<float>((p.y - center_.y) * scale_ + half_height_),
          static_cast<float>((p.z - center_.z) * scale_)};
}

}  // namespace stream_recon
