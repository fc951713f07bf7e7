// What is seen of a mesh: for every sample of the screen the nearest surface and its normal.
//
// Coordinates are those of the screen: x to the right, y up, z to the viewer, all in samples, with
// (0, 0) the lower left corner of the first sample. Normals are unit vectors that face the viewer:
// a triangle has no back.
// Guarantees: the result is a function of the triangles drawn, up to equal depths, where the first
// drawn stays. Memory: 8 bytes a sample. Thread rule: one writer.
// Source: Catmull 1974 (depth buffer); Pineda, SIGGRAPH 1988 (edge functions).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

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

  void draw(const std::array<ScreenVertex, 3>& triangle);

  std::size_t width() const { return width_; }
  std::size_t height() const { return height_; }
  /// kNothing where no triangle is.
  float depth(std::size_t x, std::size_t y) const { return depths_[y * width_ + x]; }
  Vector3f normal(std::size_t x, std::size_t y) const;

 private:
  struct PackedNormal {
    std::int16_t x = 0;
    std::int16_t y = 0;
  };

  std::size_t width_;
  std::size_t height_;
  std::vector<float> depths_;
  std::vector<PackedNormal> normals_;
};

}  // namespace stream_recon
