// Last rung of the predicates: wide integers, just wide enough for the points asked about.
//
// Guarantees: exact signs for coordinates in the safe range of CoordinateRange. Out of line: only
// nearly degenerate questions get here. Stateless. Cost: some 50 ns where the coordinates span
// up to 61 binary places (nearly all clouds), ten times that up to 125, microseconds up to 390.
#pragma once

#include <array>

#include "spatial/point.h"

namespace stream_recon::detail {

/// Sign of (b - a) x (c - a) in x and y.
int exact_orient_xy(const Point3& a, const Point3& b, const Point3& c);
/// Sign of |b - a, c - a, d - a|.
int exact_orient3d(const Point3& a, const Point3& b, const Point3& c, const Point3& d);

int exact_in_sphere(const std::array<Point3, 5>& points);
/// Relative to the orientation of the first three points in x and y.
int exact_in_circle_xy(const std::array<Point3, 4>& points);

/// The same with weights; corners first, the query last.
int exact_power_test(const std::array<WeightedPoint3, 5>& sites);
int exact_power_circle_xy(const std::array<WeightedPoint3, 4>& sites);

}  // namespace stream_recon::detail
