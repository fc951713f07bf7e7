#include "tools/preview/plane_fit.h"

#include <algorithm>
#include <cmath>

#include "tools/preview/cells.h"

namespace stream_recon {
namespace {

constexpr float kRadius = 0.007F;   // of the screen's shorter side
constexpr double kDepthSpread = 1;  // of the window's radius

/// Weighted sums of z = a + b x + c y.
struct Sums {
  double w = 0, x = 0, y = 0, z = 0, xx = 0, xy = 0, yy = 0, xz = 0, yz = 0;

  void add(double weight, double dx, double dy, double dz) {
    w += weight;
    x += weight * dx;
    y += weight * dy;
    z += weight * dz;
    xx += weight * dx * dx;
    xy += weight * dx * dy;
    yy += weight * dy * dy;
    xz += weight * dx * dz;
    yz += weight * dy * dz;
  }

  Vector3f normal() const {
    const double cxx = xx - x * x / w;
    const double cxy = xy - x * y / w;
    const double cyy = yy - y * y / w;
    const double cxz = xz - x * z / w;
    const double cyz = yz - y * z / w;
    const double determinant = cxx * cyy - cxy * cxy;
    if (!(determinant > 1e-6 * w * w)) return {0, 0, 1};
    const double b = (cxz * cyy - cyz * cxy) / determinant;
    const double c = (cyz * cxx - cxz * cxy) / determinant;
    const double length = std::sqrt(b * b + c * c + 1);
    return {static_cast<float>(-b / length), static_cast<float>(-c / length),
            static_cast<float>(1 / length)};
  }
};

}  // namespace

PlaneFit::PlaneFit(const Cells& cells)
    : cells_(cells),
      radius_(std::max<std::ptrdiff_t>(3, std::lround(kRadius * cells.shorter_side()))) {}

Vector3f PlaneFit::normal(std::size_t x, std::size_t y) const {
  const auto column = static_cast<std::ptrdiff_t>(x);
  const auto row = static_cast<std::ptrdiff_t>(y);
  const double depth = cells_.depth(x, y);
  const double spread = kDepthSpread * static_cast<double>(radius_);
  Sums sums;
  for (std::ptrdiff_t dy = -radius_; dy <= radius_; ++dy) {
    for (std::ptrdiff_t dx = -radius_; dx <= radius_; ++dx) {
      const std::ptrdiff_t cx = column + dx;
      const std::ptrdiff_t cy = row + dy;
      if (cx < 0 || cy < 0 || cx >= static_cast<std::ptrdiff_t>(cells_.width()) ||
          cy >= static_cast<std::ptrdiff_t>(cells_.height())) {
        continue;
      }
      const auto at_x = static_cast<std::size_t>(cx);
      const auto at_y = static_cast<std::size_t>(cy);
      if (cells_.is_empty(at_x, at_y)) continue;
      const double dz = cells_.depth(at_x, at_y) - depth;
      const double t = dz / spread;
      sums.add(1 / (1 + t * t * t * t), static_cast<double>(dx), static_cast<double>(dy), dz);
    }
  }
  return sums.normal();
}

}  // namespace stream_recon
