// Corners and triangles of the crust on their way from their window to the surface.
//
// A vertex of the power diagram is named by its four poles; where they touch one sample, it is that
// sample. Names do not depend on windows. Thread rule: values. Memory: 56 and 16 bytes, on disk as
// in memory (docs/formats.md).
#pragma once

#include <array>
#include <cstdint>
#include <tuple>
#include <type_traits>

#include "spatial/point.h"

namespace stream_recon {

struct CrustVertexName {
  std::uint32_t sample =
      0;  ///< rank: of itself, or of the sample that most of the four poles touch
  std::array<std::uint32_t, 4> poles{};  ///< numbers, ascending; all 0: the sample itself

  bool is_sample() const { return poles[1] == 0; }

  friend bool operator==(const CrustVertexName&, const CrustVertexName&) = default;
  friend bool operator<(const CrustVertexName& a, const CrustVertexName& b) {
    return std::tie(a.sample, a.poles) < std::tie(b.sample, b.poles);
  }
};

struct CrustVertex {
  CrustVertexName name;
  std::uint32_t window = 0;     ///< as CrustWindows::windows numbers them
  std::uint32_t position = 0;   ///< among the vertices of its window
  std::uint32_t is_astray = 0;  ///< 1: the point tells nothing, the vertex goes to the sample
  Point3 point;

  friend bool operator<(const CrustVertex& a, const CrustVertex& b) {
    return std::tie(a.name, a.window) < std::tie(b.name, b.window);
  }
};

struct CrustTriangle {
  std::array<std::uint32_t, 3>
      corners{};    ///< positions in the window, counterclockwise from outside
  float delta = 0;  ///< angle of its two balls, degrees
};

static_assert(sizeof(CrustVertex) == 56 && std::is_trivially_copyable_v<CrustVertex>);
static_assert(sizeof(CrustTriangle) == 16 && std::is_trivially_copyable_v<CrustTriangle>);

}  // namespace stream_recon
