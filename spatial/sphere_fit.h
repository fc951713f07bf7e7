// The sphere that points lie on, nearly, and how high over it they are.
//
// Guarantees: heights are within height_error() of the exact ones, whatever the sphere: also where
// nothing but the rounding of the coordinates is left. A fit promises nothing but finite numbers.
// Thread rule: pure. Cost: about 30 ns a height; 10 us a fit of 64 points.
#pragma once

#include <cmath>
#include <optional>
#include <span>

#include "spatial/point.h"

namespace stream_recon {

struct Sphere {
  Point3 centre;
  double squared_radius = 0;

  friend bool operator==(const Sphere&, const Sphere&) = default;
};

/// The power |p - centre|^2 - squared_radius: negative inside.
double height_over(const Sphere& sphere, const Point3& p);

/// Bound of the rounding of a height_over().
inline double height_error(const Sphere& sphere, double height) {
  return 0x1p-52 * std::abs(height) + 0x1p-95 * (std::abs(height) + 2 * sphere.squared_radius);
}

struct Heights {
  double low = 0;
  double high = 0;
};

/// \pre points are not empty
Heights heights_over(const Sphere& sphere, std::span<const Point3> points);

/// The sphere of least squares in the heights; nothing for points in a plane, or all but.
std::optional<Sphere> fit_sphere(std::span<const Point3> points);

}  // namespace stream_recon
