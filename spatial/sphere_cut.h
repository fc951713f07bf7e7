// What a ball is for points near a sphere: a half-space.
//
// The powers of a point to the ball and to the sphere differ by a linear function of the point. At
// the corners of the ball's tetrahedron it is the negative of their heights over the sphere; so
// where all points lie on the sphere but for rounding, and every ball is nearly the sphere itself,
// it comes from small numbers and its error is relative to them, not to the radius.
//
// Guarantees: bounds of every error (SphereCut::error). Thread rule: pure.
// Cost: about 150 ns a cut, 2 ns a power.
#pragma once

#include <array>
#include <cmath>

#include "spatial/ball_points.h"
#include "spatial/point.h"
#include "spatial/sphere_fit.h"

namespace stream_recon {

/// The power of p to the ball is height_over(p) + at_origin + gradient.(p - origin).
struct SphereCut {
  Point3 origin;  ///< the first corner
  double at_origin = 0;
  Point3 gradient{};
  double gradient_error = 0;  ///< a length; infinite where nothing is known: a flat tetrahedron
  double at_origin_error = 0;

  bool is_known() const { return std::isfinite(gradient_error); }

  /// What the linear part may be off by, over all points no farther from `origin` than this.
  double error(double distance) const {
    const double size = std::abs(gradient.x) + std::abs(gradient.y) + std::abs(gradient.z);
    return at_origin_error + (gradient_error + 0x1p-49 * size) * distance +
           0x1p-51 * std::abs(at_origin);
  }
};

/// \param tetrahedron not coplanar
SphereCut cut_sphere(const Sphere& sphere, const std::array<Point3, 4>& tetrahedron);

using LeafHeights = std::array<double, PointPowers::kPoints>;

/// Replaces the powers that this way knows better. \param heights of the points over `sphere`
void sharpen_powers(const Sphere& sphere, const SphereCut& cut, const PointColumns& points,
                    const LeafHeights& heights, PointPowers& powers);

}  // namespace stream_recon
