#include "tools/preview/shading.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "tools/preview/cells.h"
#include "tools/preview/occlusion.h"
#include "tools/preview/smoothing.h"

namespace stream_recon {
namespace {

// Light adds up in linear colours; a square root makes them the screen's (gamma 2).
struct Color {
  float r = 0;
  float g = 0;
  float b = 0;

  friend Color operator+(const Color& a, const Color& b) {
    return {a.r + b.r, a.g + b.g, a.b + b.b};
  }
  friend Color operator*(const Color& a, const Color& b) {
    return {a.r * b.r, a.g * b.g, a.b * b.b};
  }
  friend Color operator*(float s, const Color& c) { return {s * c.r, s * c.g, s * c.b}; }
};

constexpr Color kSurface{0.84F, 0.63F, 0.50F};
constexpr Color kKeyLight{0.98F, 0.93F, 0.86F};
constexpr Color kFillLight{0.13F, 0.16F, 0.21F};
constexpr Color kSkyLight{0.24F, 0.25F, 0.28F};
constexpr Color kHighlight{0.10F, 0.10F, 0.10F};
constexpr Color kTop{0.93F, 0.94F, 0.96F};
constexpr Color kBottom{0.66F, 0.69F, 0.74F};

constexpr float kSameSurface = 4;  // cells behind the nearest sample of a cell

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

Color light_at(const Vector3f& normal, float openness) {
  const float sky = 0.55F + 0.45F * normal.y;
  const float shadow = 0.25F + 0.75F * openness;
  const Color diffuse = (shadow * lit(normal, kKeyDirection)) * kKeyLight +
                        (shadow * lit(normal, kFillDirection)) * kFillLight +
                        (openness * sky) * kSkyLight;
  return kSurface * diffuse + (shadow * sharpen(lit(normal, kKeyHalfway))) * kHighlight;
}

/// \param height 0 at the bottom, 1 at the top
Color background_at(float height) {
  return height * kTop + (1 - height) * kBottom;
}

std::uint8_t to_byte(float linear) {
  return static_cast<std::uint8_t>(std::lround(255 * std::sqrt(std::clamp(linear, 0.0F, 1.0F))));
}

/// Shades the samples of one cell after another.
class Painter {
 public:
  explicit Painter(const DepthBuffer& buffer)
      : buffer_(buffer),
        cells_(buffer),
        visibility_(sky_visibility(cells_)),
        normals_(smooth_normals(cells_)) {}

  Picture paint() const {
    Picture picture(cells_.width(), cells_.height());
    for (std::size_t y = 0; y < cells_.height(); ++y) {
      for (std::size_t x = 0; x < cells_.width(); ++x) {
        const Color mean = 0.25F * sum_of_samples(x, y);
        picture.at(x, cells_.height() - 1 - y) = {to_byte(mean.r), to_byte(mean.g),
                                                  to_byte(mean.b)};
      }
    }
    return picture;
  }

 private:
  Color sum_of_samples(std::size_t x, std::size_t y) const {
    const std::size_t at = y * cells_.width() + x;
    const float height = (static_cast<float>(y) + 0.5F) / static_cast<float>(cells_.height());
    const float openness = visibility_[at] * visibility_[at];
    Color sum;
    for (const std::size_t sy : {2 * y, 2 * y + 1}) {
      for (const std::size_t sx : {2 * x, 2 * x + 1}) {
        const float depth = buffer_.depth(sx, sy);
        if (depth == DepthBuffer::kNothing) {
          sum = sum + background_at(height);
          continue;
        }
        const bool same_surface = cells_.depth(x, y) - depth / 2 < kSameSurface;
        sum = sum + light_at(same_surface ? normals_[at] : buffer_.normal(sx, sy), openness);
      }
    }
    return sum;
  }

  const DepthBuffer& buffer_;
  Cells cells_;
  std::vector<float> visibility_;
  std::vector<Vector3f> normals_;
};

}  // namespace

Picture shade(const DepthBuffer& buffer) {
  return Painter(buffer).paint();
}

}  // namespace stream_recon
