// The Euler numbers of the folded solids, from the places where spheres around the origin touch the
// gyroid: growing, a ball gains 1 with each that is an end of the gyroid's distance from the
// origin, and loses 1 with each saddle (Morse). Its spherical part adds 1, as reflection at the
// origin swaps inside and outside.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>

#include "spatial/vector.h"
#include "tools/clouds/folded_solid.h"
#include "tools/clouds/wavy_solids.h"

namespace stream_recon {
namespace {

using Matrix = std::array<Point3, 3>;

Matrix gyroid_hessian(const Point3& p) {
  constexpr double k = kGyroidWave;
  const Point3 s{std::sin(k * p.x), std::sin(k * p.y), std::sin(k * p.z)};
  const Point3 c{std::cos(k * p.x), std::cos(k * p.y), std::cos(k * p.z)};
  const double xy = -k * k * c.x * s.y;
  const double yz = -k * k * c.y * s.z;
  const double zx = -k * k * c.z * s.x;
  return {Point3{-k * k * (s.x * c.y + s.z * c.x), xy, zx},
          Point3{xy, -k * k * (s.y * c.z + s.x * c.y), yz},
          Point3{zx, yz, -k * k * (s.z * c.x + s.y * c.z)}};
}

Point3 times(const Matrix& m, const Point3& v) {
  return {dot(m[0], v), dot(m[1], v), dot(m[2], v)};
}

/// A place on the gyroid where p = share * gradient.
struct Touch {
  Point3 p;
  double share = 0;
};

/// The second derivatives of |p|^2 / 2 - share * gyroid.
Matrix lagrangian(const Touch& touch) {
  Matrix m = gyroid_hessian(touch.p);
  for (Point3& row : m) row = scaled(row, -touch.share);
  m[0].x += 1;
  m[1].y += 1;
  m[2].z += 1;
  return m;
}

/// Solves m x = v by Cramer's rule; m is symmetric.
Point3 solved(const Matrix& m, const Point3& v) {
  const double determinant = dot(m[0], cross(m[1], m[2]));
  return scaled({dot(v, cross(m[1], m[2])), dot(v, cross(m[2], m[0])), dot(v, cross(m[0], m[1]))},
                1 / determinant);
}

/// Newton's method for p - share * gradient = 0, gyroid = 0.
std::optional<Touch> find_touch(const Point3& start) {
  Touch touch{start};
  for (int i = 0; i < 5; ++i) {
    const GyroidField field = gyroid_field(touch.p);
    const double square = dot(field.gradient, field.gradient);
    touch.p = minus(touch.p, scaled(field.gradient, field.value / square));
    touch.share = dot(touch.p, field.gradient) / square;
  }
  for (int i = 0; i < 60; ++i) {
    const GyroidField field = gyroid_field(touch.p);
    const Matrix m = lagrangian(touch);
    const Point3 miss = solved(m, minus(touch.p, scaled(field.gradient, touch.share)));
    const Point3 slope = solved(m, field.gradient);
    const double share = (dot(field.gradient, miss) - field.value) / dot(field.gradient, slope);
    const Point3 step = minus(miss, scaled(slope, share));
    const double damping = std::min(1.0, 0.05 / length(step));
    touch.p = minus(touch.p, scaled(step, damping));
    touch.share += damping * share;
    if (!(length(touch.p) < 1.3)) return std::nullopt;
    if (length(step) < 1e-14) return touch;
  }
  return std::nullopt;
}

/// +1 for an end of the distance, -1 for a saddle: the sign of the second derivatives' determinant
/// within the tangent plane.
int sign_of(const Touch& touch) {
  const Point3 normal = gyroid_field(touch.p).gradient;
  const Point3 least = std::abs(normal.x) < std::abs(normal.y) ? Point3{1, 0, 0} : Point3{0, 1, 0};
  const Point3 a = cross(normal, least);
  const Point3 b = cross(normal, a);
  const Matrix m = lagrangian(touch);
  const double mixed = dot(a, times(m, b));
  return dot(a, times(m, a)) * dot(b, times(m, b)) - mixed * mixed > 0 ? 1 : -1;
}

/// By distance from the origin.
std::multimap<double, int> find_all_touches() {
  std::map<std::array<long, 3>, Touch> found;
  Random random(1);
  for (int i = 0; i < 60000; ++i) {
    const Point3 start{1.1 * random.signed_unit(), 1.1 * random.signed_unit(),
                       1.1 * random.signed_unit()};
    const auto touch = find_touch(start);
    if (!touch) continue;
    found[{std::lround(touch->p.x * 1e6), std::lround(touch->p.y * 1e6),
           std::lround(touch->p.z * 1e6)}] = *touch;
  }
  std::multimap<double, int> touches;
  for (const auto& [place, touch] : found) touches.emplace(length(touch.p), sign_of(touch));
  return touches;
}

TEST(GyroidGenus, TruthIsTheSumOverWhereSpheresTouchTheGyroid) {
  const auto touches = find_all_touches();
  for (const double radius : {1.0, FoldedSolid::kSpongeRadius}) {
    std::int64_t euler = 1;
    double margin = 1;
    for (const auto& [distance, sign] : touches) {
      if (distance < radius) euler += sign;
      margin = std::min(margin, std::abs(distance - radius));
    }
    EXPECT_EQ(euler, FoldedSolid(radius).truth().euler);
    if (radius < 1) {
      EXPECT_GT(margin, 0.0098);
    }
  }
}

}  // namespace
}  // namespace stream_recon
