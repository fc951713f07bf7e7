// What is seen of a mesh: for every sample of the screen the nearest surface, its normal and paint.
//
// Coordinates are those of the screen: x to the right, y up, z to the viewer, all in samples, with
// (0, 0) the lower left corner of the first sample. Normals are unit vectors that face the viewer:
// a triangle has no back.
// Guarantees: the result is a function of the triangles drawn, up to equal depths, where the first
// drawn stays. Memory: 10 bytes a sample. Thread rule: one writer.
// Source: Catmull 1974 (depth buffer); Pineda, SIGGRAPH 1988 (edge functions).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "tools/preview/coloring.h"

namespace stream_recon {

struct Vector3f {
  float x = 0;
  float y = 0;
  float z = 0;
};

struct ScreenVertex {
  Vector3f position;
  Vector3f normal;  ///< of any length above 0, z >= 0
};

class DepthBuffer {
 public:
  static constexpr float kNothing = -std::numeric_limits<float>::infinity();

  DepthBuffer(std::size_t width, std::size_t height);

  void draw(const std::array<ScreenVertex, 3>& triangle, Paint paint = 0);
  /// A point as a disc of `radius` samples that bulges a little; its normal is not known.
  void draw_disc(const Vector3f& center, float radius, Paint paint = 0);

  std::size_t width() const { return width_; }
  std::size_t height() const { return height_; }
  /// kNothing where no triangle is.
  float depth(std::size_t x, std::size_t y) const { return depths_[y * width_ + x]; }
  /// Towards the viewer where it is not known.
  Vector3f normal(std::size_t x, std::size_t y) const;
  bool has_normal(std::size_t x, std::size_t y) const {
    return normals_[y * width_ + x].x != kUnknown;
  }
  Paint paint(std::size_t x, std::size_t y) const { return paints_[y * width_ + x]; }

 private:
  static constexpr std::int16_t kUnknown = std::numeric_limits<std::int16_t>::min();

  struct PackedNormal {
    std::int16_t x = 0;
    std::int16_t y = 0;
  };

  std::size_t width_;
  std::size_t height_;
  std::vector<float> depths_;
  std::vector<PackedNormal> normals_;
  std::vector<Paint> paints_;
};

}  // namespace stream_recon
