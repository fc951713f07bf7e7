#include "tools/check/triangle_shape.h"

#include <cmath>
#include <limits>
#include <optional>

#include "io/error.h"
#include "spatial/coordinate_range.h"
#include "spatial/predicates.h"
#include "spatial/vector.h"

namespace stream_recon {
namespace {

/// Whether p q - r s is certainly not 0, though p, q, r, s are rounded differences. Each product
/// has a relative error below 3 units of 2^-53, their difference one more.
bool is_surely_nonzero(double p, double q, double r, double s) {
  constexpr double kError = 8 * std::numeric_limits<double>::epsilon();
  const double first = p * q;
  const double second = r * s;
  const double reach = std::abs(first) + std::abs(second);
  return std::abs(first - second) > kError * reach && reach > 1e-200 && reach < 1e200;
}

bool is_flat_exactly(const Corners& corners) {
  CoordinateRange range;
  for (const Point3& corner : corners) range.extend(corner);
  const std::optional<double> power = range.scale();
  if (!power) {
    throw InputError(
        "coordinates of one triangle are more than 390 powers of two apart: too wide for exact "
        "tests; scale or clean the mesh");
  }
  const Predicates predicates(range.times(*power));
  const auto& [a, b, c] = corners;
  return predicates.coplanar_orientation(scaled(a, *power), scaled(b, *power), scaled(c, *power)) ==
         0;
}

}  // namespace

double area(const Corners& corners) {
  const auto& [a, b, c] = corners;
  return length(cross(minus(b, a), minus(c, a))) / 2;
}

double signed_volume(const Corners& corners, const Point3& origin) {
  const Point3 a = minus(corners[0], origin);
  return dot(a, cross(minus(corners[1], origin), minus(corners[2], origin))) / 6;
}

bool is_flat(const Corners& corners) {
  const Point3 u = minus(corners[1], corners[0]);
  const Point3 v = minus(corners[2], corners[0]);
  if (is_surely_nonzero(u.x, v.y, u.y, v.x) || is_surely_nonzero(u.y, v.z, u.z, v.y) ||
      is_surely_nonzero(u.z, v.x, u.x, v.z)) {
    return false;
  }
  return is_flat_exactly(corners);
}

}  // namespace stream_recon
