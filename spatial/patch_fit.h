// The piece of a paraboloid that points near a surface lie on, by least squares.
//
// Guarantees: none but finite numbers and axes of unit length, at right angles but for rounding;
// how far the points are from it is for the caller to find out.
// Thread rule: pure. Cost: about 2 us for 64 points or more.
#pragma once

#include <array>
#include <span>

#include "spatial/point.h"

namespace stream_recon {

/// The points m + u a + w b + h n with h = slope.(u, w) + (curvature u^2 + curvature w^2) / 2;
/// m, a, b and n are `middle`, `axes` and `normal`.
struct Patch {
  Point3 middle;
  std::array<Point3, 2> axes;  ///< principal directions of curvature
  Point3 normal;
  std::array<double, 2> slope{};
  std::array<double, 2> curvature{};
};

/// \pre not empty
Patch fit_patch(std::span<const Point3> points);

}  // namespace stream_recon
