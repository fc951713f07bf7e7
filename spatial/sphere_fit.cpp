#include "spatial/sphere_fit.h"

#include <algorithm>

#include "spatial/double_double.h"
#include "spatial/principal_plane.h"
#include "spatial/vector.h"

namespace stream_recon {
namespace {

// Spheres of a larger radius, in units of what the points extend to, are told as planes.
constexpr double kLeastVolume = 1e-14;
// The first two fits leave what doubles cannot tell of points far from the centre.
constexpr int kFits = 3;

// (a - b)^2. The difference of two doubles is a sum of two, exactly; the last term is rounded.
DoubleDouble squared_difference(double a, double b) {
  const DoubleDouble d = exact_sum(a, -b);
  const DoubleDouble square = exact_product(d.high, d.high);
  return quick_sum(square.high, square.low + (2 * d.high * d.low + d.low * d.low));
}

DoubleDouble squared_distance(const Point3& p, const Point3& q) {
  return squared_difference(p.x, q.x) + squared_difference(p.y, q.y) + squared_difference(p.z, q.z);
}

Point3 mean(std::span<const Point3> points) {
  // Relative to the first: a sum of coordinates far from the origin would be rounded more.
  Point3 sum;
  for (const Point3& p : points) sum = plus(sum, minus(p, points[0]));
  return plus(points[0], scaled(sum, 1 / static_cast<double>(points.size())));
}

/// The vector x of M x = v, or nothing where M is almost singular.
std::optional<Point3> solve(const Moments& m, const Point3& v) {
  const Point3 a{m.xx, m.xy, m.xz};
  const Point3 b{m.xy, m.yy, m.yz};
  const Point3 c{m.xz, m.yz, m.zz};
  const Point3 bc = cross(b, c);
  const double determinant = dot(a, bc);
  const double size = m.xx + m.yy + m.zz;
  if (!(determinant > kLeastVolume * (size * size * size))) return std::nullopt;
  const Point3 ca = cross(c, a);
  const Point3 ab = cross(a, b);
  return scaled(plus(plus(scaled(bc, v.x), scaled(ca, v.y)), scaled(ab, v.z)), 1 / determinant);
}

}  // namespace

double height_over(const Sphere& sphere, const Point3& p) {
  return (squared_distance(p, sphere.centre) + DoubleDouble{-sphere.squared_radius, 0}).value();
}

Heights heights_over(const Sphere& sphere, std::span<const Point3> points) {
  Heights heights{height_over(sphere, points[0]), height_over(sphere, points[0])};
  for (const Point3& p : points) {
    const double height = height_over(sphere, p);
    heights = {std::min(heights.low, height), std::max(heights.high, height)};
  }
  return heights;
}

// A move of the centre by v changes the heights by -2 v.p and a constant: so half of the heights'
// own slope is what the centre is off.
std::optional<Sphere> fit_sphere(std::span<const Point3> points) {
  if (points.size() < 4) return std::nullopt;
  const Point3 middle = mean(points);
  Moments moments;
  for (const Point3& p : points) moments.add(minus(p, middle));
  Sphere sphere{middle, 0};
  for (int fit = 0; fit < kFits; ++fit) {
    sphere.squared_radius = squared_distance(points[0], sphere.centre).value();
    Point3 tilt;
    for (const Point3& p : points) {
      tilt = plus(tilt, scaled(minus(p, middle), height_over(sphere, p)));
    }
    const auto slope = solve(moments, tilt);
    if (!slope || !is_finite(*slope)) return std::nullopt;
    sphere.centre = plus(sphere.centre, scaled(*slope, 0.5));
  }
  sphere.squared_radius = squared_distance(points[0], sphere.centre).value();
  const Heights heights = heights_over(sphere, points);
  sphere.squared_radius += (heights.low + heights.high) / 2;
  if (!std::isfinite(sphere.squared_radius)) return std::nullopt;
  return sphere;
}

}  // namespace stream_recon
