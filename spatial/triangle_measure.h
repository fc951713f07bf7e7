// What a triangle adds to the area of a surface and to the volume inside it.
//
// Thread rule: pure functions. Cost: 10 ns an area, 60 ns a volume.
#pragma once

#include "spatial/double_double.h"
#include "spatial/vector.h"

namespace stream_recon {

/// Squares of the unit of length.
inline double triangle_area(const Point3& a, const Point3& b, const Point3& c) {
  return length(cross(minus(b, a), minus(c, a))) / 2;
}

/// Six times the signed volume of the triangle's cone from the origin: positive where it is
/// counterclockwise seen from the far side. The sum over a closed surface is six times its volume,
/// to 2^-100 of the largest terms, so that the sign of thin bodies far from the origin comes out.
/// \pre The coordinates are in the safe range of CoordinateRange.
constexpr DoubleDouble six_cone_volumes(const Point3& a, const Point3& b, const Point3& c) {
  const auto minor = [](double p, double q, double r, double s) {
    return exact_product(p, q) - exact_product(r, s);
  };
  return minor(b.y, c.z, b.z, c.y) * a.x + minor(b.z, c.x, b.x, c.z) * a.y +
         minor(b.x, c.y, b.y, c.x) * a.z;
}

}  // namespace stream_recon
