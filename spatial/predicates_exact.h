// Last rungs of the predicates: wide integers for clouds on a lattice, expansions for all others.
//
// Guarantees: exact signs for coordinates in the safe range of CoordinateRange. Out of line: only
// nearly degenerate questions get here. Stateless. Costs 30 to 100 ns in integers, 0.3 to 20 us in
// expansions (few components for points on a grid, most where coordinates differ by many orders
// of magnitude).
#pragma once

#include <array>
#include <cstdint>

#include "spatial/point.h"

namespace stream_recon::detail {

/// Signs from differences that are multiples of 1 / inverse_unit; false in `decided` where they are
/// too large for 128 bits.
struct IntegerSign {
  bool decided;
  int sign;
};
IntegerSign integer_determinant_sign(const std::array<Point3, 3>& rows, double inverse_unit);
IntegerSign integer_in_sphere_sign(const std::array<Point3, 4>& rows, double inverse_unit);
IntegerSign integer_in_circle_xy_sign(const std::array<Point3, 3>& rows, double inverse_unit);

/// Sign of (b - a) x (c - a) in x and y.
int exact_orient_xy(const Point3& a, const Point3& b, const Point3& c);
/// Sign of |b - a, c - a, d - a|.
int exact_orient3d(const Point3& a, const Point3& b, const Point3& c, const Point3& d);

/// Signs of the power tests; corners first, the query last. For zero weights the in-sphere test.
int exact_power_test(const std::array<WeightedPoint3, 5>& sites);
/// The same in the plane; the sign is relative to the orientation of the corners in x and y.
int exact_power_circle_xy(const std::array<WeightedPoint3, 4>& sites);

}  // namespace stream_recon::detail
