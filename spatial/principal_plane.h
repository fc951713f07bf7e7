// The plane that points spread out in, from the sums of their products.
//
// Guarantees: the same bits for the same sums: only additions, products, quotients and roots.
// Thread rule: pure. Cost: about 60 ns.
#pragma once

#include <array>

#include "spatial/point.h"

namespace stream_recon {

/// Symmetric: the sum over vectors of their outer products.
struct Moments {
  double xx = 0, xy = 0, xz = 0, yy = 0, yz = 0, zz = 0;

  void add(const Point3& v) {
    xx += v.x * v.x;
    xy += v.x * v.y;
    xz += v.x * v.z;
    yy += v.y * v.y;
    yz += v.y * v.z;
    zz += v.z * v.z;
  }

  /// `share` times the products of v: about the mean of n vectors, v their sum and share 1 / n.
  void subtract(const Point3& v, double share) {
    xx -= share * v.x * v.x;
    xy -= share * v.x * v.y;
    xz -= share * v.x * v.z;
    yy -= share * v.y * v.y;
    yz -= share * v.y * v.z;
    zz -= share * v.z * v.z;
  }

  /// As of vectors whose squares add up to 1, if that can be.
  Moments normalized() const {
    const double size = xx + yy + zz;
    const double s = size > 0 ? 1 / size : 1;
    return {xx * s, xy * s, xz * s, yy * s, yz * s, zz * s};
  }
};

/// The direction in which the vectors extend least, of unit length; any where they do not tell.
Point3 least_direction(const Moments& moments);

/// Two directions of unit length at right angles to `normal`, of unit length, and to each other.
std::array<Point3, 2> across(const Point3& normal);

}  // namespace stream_recon
