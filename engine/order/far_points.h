// Eight points far around a cloud, so that no sample of it lies on the convex hull and every sample
// has a ball outside: the corners of a cube.
//
// Guarantees: a function of the box alone; the cube holds the box, and its half edge is from 2.5 to
// 5 times the box's longest edge; coordinates are short binary fractions, whose exactness costs the
// predicates nothing. Thread rule: pure. Source: Amenta, Choi, Kolluri, The power crust, 2001,
// section 4 (a bounding box five times as large).
#pragma once

#include <array>

#include "spatial/box.h"
#include "spatial/point.h"

namespace stream_recon {

/// \pre the box is not empty
/// \throw InputError its extent is beyond what the arithmetic of balls can take
std::array<Point3, 8> far_points(const Box3& box);

}  // namespace stream_recon
