#include "tools/preview/depth_buffer.h"

#include <algorithm>
#include <cmath>

namespace stream_recon {
namespace {

constexpr float kUnit = 32767;
constexpr float kBulge = 0.3F;  // so that of two discs at a depth the nearer centre is seen

/// Sample centres (i + 0.5) between low and high, inside [0, size).
struct SampleRange {
  std::size_t begin = 0;
  std::size_t end = 0;
  SampleRange(float low, float high, std::size_t size) {
    const auto limit = static_cast<float>(size);
    begin = static_cast<std::size_t>(std::clamp(std::ceil(low - 0.5F), 0.0F, limit));
    end = static_cast<std::size_t>(std::clamp(std::floor(high + 0.5F), 0.0F, limit));
  }
};

/// Twice the signed area of (a, b, p), linear in p.
double edge(const Vector3f& a, const Vector3f& b, double x, double y) {
  return (static_cast<double>(b.x) - a.x) * (y - a.y) -
         (static_cast<double>(b.y) - a.y) * (x - a.x);
}

Vector3f blend(const std::array<ScreenVertex, 3>& triangle, const std::array<float, 3>& weight) {
  Vector3f sum;
  for (int i = 0; i < 3; ++i) {
    sum.x += weight[i] * triangle[i].normal.x;
    sum.y += weight[i] * triangle[i].normal.y;
    sum.z += weight[i] * triangle[i].normal.z;
  }
  return sum;
}

}  // namespace

DepthBuffer::DepthBuffer(std::size_t width, std::size_t height)
    : width_(width),
      height_(height),
      depths_(width * height, kNothing),
      normals_(width * height),
      paints_(width * height) {}

void DepthBuffer::draw(const std::array<ScreenVertex, 3>& triangle, Paint paint) {
  const auto& [a, b, c] = triangle;
  const double area = edge(a.position, b.position, c.position.x, c.position.y);
  if (area == 0 || !std::isfinite(area)) return;
  const auto [left, right] = std::minmax({a.position.x, b.position.x, c.position.x});
  const auto [low, high] = std::minmax({a.position.y, b.position.y, c.position.y});
  const SampleRange columns(left, right, width_);
  const SampleRange rows(low, high, height_);
  for (std::size_t row = rows.begin; row < rows.end; ++row) {
    for (std::size_t column = columns.begin; column < columns.end; ++column) {
      const double x = static_cast<double>(column) + 0.5;
      const double y = static_cast<double>(row) + 0.5;
      const std::array<float, 3> weight{
          static_cast<float>(edge(b.position, c.position, x, y) / area),
          static_cast<float>(edge(c.position, a.position, x, y) / area),
          static_cast<float>(edge(a.position, b.position, x, y) / area)};
      if (weight[0] < 0 || weight[1] < 0 || weight[2] < 0) continue;
      const float depth =
          weight[0] * a.position.z + weight[1] * b.position.z + weight[2] * c.position.z;
      const std::size_t at = row * width_ + column;
      if (!(depth > depths_[at])) continue;
      depths_[at] = depth;
      paints_[at] = paint;
      const Vector3f n = blend(triangle, weight);
      const float length = std::sqrt(n.x * n.x + n.y * n.y + n.z * n.z);
      if (length == 0) continue;
      normals_[at] = {static_cast<std::int16_t>(std::lround(kUnit * n.x / length)),
                      static_cast<std::int16_t>(std::lround(kUnit * n.y / length))};
    }
  }
}

void DepthBuffer::draw_disc(const Vector3f& center, float radius, Paint paint) {
  if (!std::isfinite(center.x) || !std::isfinite(center.y) || !std::isfinite(center.z)) return;
  const SampleRange columns(center.x - radius, center.x + radius, width_);
  const SampleRange rows(center.y - radius, center.y + radius, height_);
  for (std::size_t row = rows.begin; row < rows.end; ++row) {
    for (std::size_t column = columns.begin; column < columns.end; ++column) {
      const float dx = static_cast<float>(column) + 0.5F - center.x;
      const float dy = static_cast<float>(row) + 0.5F - center.y;
      const float square = dx * dx + dy * dy;
      if (square > radius * radius) continue;
      const float depth = center.z - kBulge * square / radius;
      const std::size_t at = row * width_ + column;
      if (!(depth > depths_[at])) continue;
      depths_[at] = depth;
      paints_[at] = paint;
      normals_[at] = {kUnknown, 0};
    }
  }
}

Vector3f DepthBuffer::normal(std::size_t x, std::size_t y) const {
  if (!has_normal(x, y)) return {0, 0, 1};
  const PackedNormal packed = normals_[y * width_ + x];
  const float nx = static_cast<float>(packed.x) / kUnit;
  const float ny = static_cast<float>(packed.y) / kUnit;
  return {nx, ny, std::sqrt(std::max(0.0F, 1 - nx * nx - ny * ny))};
}

}  // namespace stream_recon
