// The measures of one triangle.
//
// Guarantees: is_flat() is exact. Thread rule: pure functions. Cost: about 10 ns; is_flat() of a
// nearly flat triangle about 1 us.
#pragma once

#include <array>

#include "spatial/point.h"

namespace stream_recon {

using Corners = std::array<Point3, 3>;

double area(const Corners& corners);

/// Of the tetrahedron from `origin`, positive if it sees the triangle clockwise: from inside.
double signed_volume(const Corners& corners, const Point3& origin);

/// Whether the corners lie on one line or in one point.
/// \throw InputError coordinates too far apart for exact tests
bool is_flat(const Corners& corners);

}  // namespace stream_recon
