#include "tools/preview/occlusion.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>

namespace stream_recon {
namespace {

constexpr int kDirections = 16;
constexpr int kSteps = 8;
constexpr float kReach = 0.11F;     // of the screen's shorter side
constexpr float kTangent = 0.08F;   // rises less than this are the surface's own roughness
constexpr float kFirstStep = 1.5F;  // cells

struct Ray {
  float x;
  float y;
};

std::array<Ray, kDirections> make_rays() {
  std::array<Ray, kDirections> rays{};
  for (int i = 0; i < kDirections; ++i) {
    const double angle = 2 * std::numbers::pi * (i + 0.25) / kDirections;
    rays[i] = {static_cast<float>(std::cos(angle)), static_cast<float>(std::sin(angle))};
  }
  return rays;
}

/// Distances grow by one factor from the first step to the reach.
std::array<float, kSteps> make_distances(float reach) {
  std::array<float, kSteps> distances{};
  for (int i = 0; i < kSteps; ++i)
    distances[i] = kFirstStep * std::pow(reach / kFirstStep, static_cast<float>(i) / (kSteps - 1));
  return distances;
}

class Horizon {
 public:
  explicit Horizon(const Cells& cells)
      : cells_(cells),
        reach_(std::max(4.0F, kReach * cells.shorter_side())),
        rays_(make_rays()),
        distances_(make_distances(reach_)) {}

  float visibility(std::size_t x, std::size_t y) const {
    if (cells_.is_empty(x, y)) return 1;
    float hidden = 0;
    for (const Ray& ray : rays_) hidden += highest_rise(x, y, ray);
    return 1 - hidden / kDirections;
  }

 private:
  /// The largest sine of a rise over the tangent plane along a ray, faded out towards the reach
  /// and for what hangs far in front.
  float highest_rise(std::size_t x, std::size_t y, const Ray& ray) const {
    const Vector3f& normal = cells_.normal(x, y);
    const float depth = cells_.depth(x, y);
    float highest = 0;
    for (const float distance : distances_) {
      const float sx = static_cast<float>(x) + 0.5F + distance * ray.x;
      const float sy = static_cast<float>(y) + 0.5F + distance * ray.y;
      if (!on_screen(sx, sy)) break;
      const auto cx = static_cast<std::int32_t>(sx);
      const auto cy = static_cast<std::int32_t>(sy);
      const float other = cells_.depth(static_cast<std::size_t>(cx), static_cast<std::size_t>(cy));
      if (other == DepthBuffer::kNothing) continue;
      const auto dx = static_cast<float>(cx - static_cast<std::int32_t>(x));
      const auto dy = static_cast<float>(cy - static_cast<std::int32_t>(y));
      const float dz = other - depth;
      const float rise = normal.x * dx + normal.y * dy + normal.z * dz;
      if (rise <= 0) continue;
      const float sine = rise / std::sqrt(dx * dx + dy * dy + dz * dz);
      const float nearness = 1 - (distance / reach_) * (distance / reach_);
      const float same_body = std::clamp(2 - dz / reach_, 0.0F, 1.0F);
      highest = std::max(highest, (sine - kTangent) * nearness * same_body);
    }
    return highest;
  }

  bool on_screen(float x, float y) const {
    return x >= 0 && y >= 0 && x < static_cast<float>(cells_.width()) &&
           y < static_cast<float>(cells_.height());
  }

  const Cells& cells_;
  float reach_;
  std::array<Ray, kDirections> rays_;
  std::array<float, kSteps> distances_;
};

}  // namespace

std::vector<float> sky_visibility(const Cells& cells) {
  const Horizon horizon(cells);
  std::vector<float> visibility;
  visibility.reserve(cells.width() * cells.height());
  for (std::size_t y = 0; y < cells.height(); ++y)
    for (std::size_t x = 0; x < cells.width(); ++x) visibility.push_back(horizon.visibility(x, y));
  return visibility;
}

}  // namespace stream_recon
