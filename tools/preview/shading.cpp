#include "tools/preview/shading.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "tools/preview/cells.h"
#include "tools/preview/occlusion.h"
#include "tools/preview/smoothing.h"

namespace stream_recon {
namespace {

constexpr Color kKeyLight{0.98F, 0.93F, 0.86F};
constexpr Color kFillLight{0.13F, 0.16F, 0.21F};
constexpr Color kSkyLight{0.24F, 0.25F, 0.28F};
constexpr Color kHighlight{0.10F, 0.10F, 0.10F};

constexpr float kSameSurface = 4;   // cells behind the nearest sample of a cell
constexpr float kFarthest = 0.55F;  // light of the farthest point

constexpr Vector3f kKeyDirection{-0.442F, 0.590F, 0.676F};
constexpr Vector3f kFillDirection{0.808F, 0.101F, 0.580F};
// Halfway between the key light and the viewer.
constexpr Vector3f kKeyHalfway{-0.2414F, 0.3223F, 0.9154F};

float dot(const Vector3f& a, const Vector3f& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

float lit(const Vector3f& normal, const Vector3f& light) {
  return std::max(0.0F, dot(normal, light));
}

/// x to the power of 32.
float sharpen(float x) {
  for (int i = 0; i < 5; ++i) x *= x;
  return x;
}

Color light_at(const Color& surface, const Vector3f& normal, float openness) {
  const float sky = 0.55F + 0.45F * normal.y;
  const float shadow = 0.25F + 0.75F * openness;
  const Color diffuse = (shadow * lit(normal, kKeyDirection)) * kKeyLight +
                        (shadow * lit(normal, kFillDirection)) * kFillLight +
                        (openness * sky) * kSkyLight;
  return surface * diffuse + (shadow * sharpen(lit(normal, kKeyHalfway))) * kHighlight;
}

/// Shades the samples of one cell after another.
class Painter {
 public:
  Painter(const DepthBuffer& buffer, const ShadeOptions& options)
      : buffer_(buffer),
        options_(options),
        cells_(buffer),
        visibility_(sky_visibility(cells_)),
        normals_(smooth_normals(cells_)) {
    find_depths();
  }

  Picture paint() const {
    Picture picture(cells_.width(), cells_.height());
    for (std::size_t y = 0; y < cells_.height(); ++y) {
      const std::size_t row = cells_.height() - 1 - y;
      const float height = (static_cast<float>(y) + 0.5F) / static_cast<float>(cells_.height());
      const Color behind = options_.background.color_at(height);
      for (std::size_t x = 0; x < cells_.width(); ++x) {
        const Light light = sum_of_samples(x, y);
        if (!options_.background.is_transparent()) {
          picture.at(x, row) =
              to_bytes(0.25F * (light.sum + static_cast<float>(4 - light.samples) * behind));
          continue;
        }
        if (light.samples > 0) {
          picture.at(x, row) = to_bytes(1 / static_cast<float>(light.samples) * light.sum);
        }
        picture.opacity(x, row) = static_cast<std::uint8_t>(light.samples * 255 / 4);
      }
    }
    return picture;
  }

 private:
  /// Of the samples of a cell where something is.
  struct Light {
    Color sum;
    int samples = 0;
  };

  Light sum_of_samples(std::size_t x, std::size_t y) const {
    const std::size_t at = y * cells_.width() + x;
    const float openness = visibility_[at] * visibility_[at];
    Light light;
    for (const std::size_t sy : {2 * y, 2 * y + 1}) {
      for (const std::size_t sx : {2 * x, 2 * x + 1}) {
        const float depth = buffer_.depth(sx, sy);
        if (depth == DepthBuffer::kNothing) continue;
        const bool same_surface = cells_.depth(x, y) - depth / 2 < kSameSurface;
        const Vector3f normal = same_surface ? normals_[at] : buffer_.normal(sx, sy);
        const Color color = light_at(options_.palette[buffer_.paint(sx, sy)], normal, openness);
        light.sum = light.sum + (buffer_.has_normal(sx, sy) ? 1 : fading(depth)) * color;
        ++light.samples;
      }
    }
    return light;
  }

  void find_depths() {
    nearest_ = DepthBuffer::kNothing;
    farthest_ = -DepthBuffer::kNothing;
    for (std::size_t y = 0; y < buffer_.height(); ++y) {
      for (std::size_t x = 0; x < buffer_.width(); ++x) {
        const float depth = buffer_.depth(x, y);
        if (depth == DepthBuffer::kNothing) continue;
        nearest_ = std::max(nearest_, depth);
        farthest_ = std::min(farthest_, depth);
      }
    }
  }

  float fading(float depth) const {
    const float range = nearest_ - farthest_;
    if (!(range > 0)) return 1;
    return kFarthest + (1 - kFarthest) * (depth - farthest_) / range;
  }

  const DepthBuffer& buffer_;
  const ShadeOptions& options_;
  Cells cells_;
  std::vector<float> visibility_;
  std::vector<Vector3f> normals_;
  float nearest_ = 0;
  float farthest_ = 0;
};

}  // namespace

Picture shade(const DepthBuffer& buffer, const ShadeOptions& options) {
  return Painter(buffer, options).paint();
}

}  // namespace stream_recon
