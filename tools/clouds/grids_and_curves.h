// Points of degenerate clouds: grids, lines, planes and curves, each with its index or a generator.
//
// Guarantees: grids, lines and planes are exact (their coordinates are small integers or share one
// binary scale, so that no rounding moves a point off). Thread rule: stateless but the generator.
#pragma once

#include <cstdint>

#include "spatial/point.h"
#include "tools/clouds/random.h"

namespace stream_recon {

/// A block of integer points in scan order (z, y, x) with sides as equal as may be.
class GridBlock {
 public:
  explicit GridBlock(std::uint64_t count);
  Point3 point(std::uint64_t index) const;

 private:
  std::uint64_t side_;
};

/// On the line through 0 in direction (1, 2, 3).
Point3 collinear_point(Random& random);

/// In the plane z = x + y.
Point3 coplanar_point(Random& random);

/// Evenly spaced on the unit circle in the plane z = 0.
Point3 circle_point(std::uint64_t index, std::uint64_t count);

/// Evenly spaced on eight turns of the helix of radius 1 and height 4.
Point3 helix_point(std::uint64_t index, std::uint64_t count);

/// Even indices on the line y = 0.5, z = 0, odd ones on x = 0.5, z = 1: each segment of one line
/// makes a tetrahedron with each of the other.
Point3 skew_lines_point(std::uint64_t index, std::uint64_t count);

}  // namespace stream_recon
