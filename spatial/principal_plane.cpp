#include "spatial/principal_plane.h"

#include <algorithm>
#include <cmath>

#include "spatial/vector.h"

namespace stream_recon {

// The direction of least extent: inverse iteration by the adjugate, whose columns are what any
// start becomes after one step; two squarings make it two more doublings. Any unit vector would do
// for correctness.
Point3 least_direction(const Moments& m) {
  double a = m.yy * m.zz - m.yz * m.yz;
  double b = m.xz * m.yz - m.xy * m.zz;
  double c = m.xy * m.yz - m.xz * m.yy;
  double d = m.xx * m.zz - m.xz * m.xz;
  double e = m.xy * m.xz - m.xx * m.yz;
  double f = m.xx * m.yy - m.xy * m.xy;
  for (int step = 0; step < 3; ++step) {
    const double size = std::max({std::abs(a), std::abs(d), std::abs(f)});
    if (!(size > 0) || !std::isfinite(size)) return {0, 0, 1};
    const double s = 1 / size;
    a *= s, b *= s, c *= s, d *= s, e *= s, f *= s;
    if (step == 2) break;
    const double aa = a * a + b * b + c * c;
    const double ab = a * b + b * d + c * e;
    const double ac = a * c + b * e + c * f;
    const double dd = b * b + d * d + e * e;
    const double de = b * c + d * e + e * f;
    const double ff = c * c + e * e + f * f;
    a = aa, b = ab, c = ac, d = dd, e = de, f = ff;
  }
  Point3 column{a, b, c};
  if (d > a && d >= f) column = {b, d, e};
  if (f > a && f > d) column = {c, e, f};
  return scaled(column, 1 / length(column));
}

std::array<Point3, 2> across(const Point3& normal) {
  const Point3 start = std::abs(normal.x) < 0.6 ? Point3{1, 0, 0} : Point3{0, 1, 0};
  const Point3 a = cross(normal, start);
  const Point3 unit = scaled(a, 1 / length(a));
  return {unit, cross(normal, unit)};
}

}  // namespace stream_recon
