// Heights over spheres, and what balls are for the points of one, against rational arithmetic.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "spatial/sphere_cut.h"
#include "tests/point_families.h"

namespace stream_recon {
namespace {

using Rational = boost::multiprecision::cpp_rational;
using Corners = std::array<Point3, 4>;

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr std::uint64_t kSeed = 41;

Rational squared_distance(const Point3& a, const Point3& b) {
  const Rational x = Rational(a.x) - Rational(b.x);
  const Rational y = Rational(a.y) - Rational(b.y);
  const Rational z = Rational(a.z) - Rational(b.z);
  return x * x + y * y + z * z;
}

/// Sign and size of the in-sphere determinant over that of the tetrahedron: the exact power of p.
Rational exact_power(const Corners& t, const Point3& p) {
  using Vector = std::array<Rational, 3>;
  const auto from_first = [&](const Point3& q) {
    return Vector{Rational(q.x) - Rational(t[0].x), Rational(q.y) - Rational(t[0].y),
                  Rational(q.z) - Rational(t[0].z)};
  };
  const auto cross = [](const Vector& a, const Vector& b) {
    return Vector{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
  };
  const auto dot = [](const Vector& a, const Vector& b) -> Rational {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  };
  const Vector u = from_first(t[1]);
  const Vector v = from_first(t[2]);
  const Vector w = from_first(t[3]);
  const Vector q = from_first(p);
  const Vector vw = cross(v, w);
  const Rational numerator =
      dot(u, u) * dot(vw, q) + dot(v, v) * dot(cross(w, u), q) + dot(w, w) * dot(cross(u, v), q);
  return dot(q, q) - numerator / dot(u, vw);
}

/// Points of a sphere: `near` each other, and rounded to floats or not.
struct SphereFamily {
  Point3 centre;
  double radius;
  double near;
  bool floats;

  Point3 draw(std::mt19937_64& random, double spread) const {
    const Point3 r = families::random_point(random);
    const Point3 d{1 + spread * r.x, spread * r.y, spread * r.z};
    const double share = radius / std::sqrt(d.x * d.x + d.y * d.y + d.z * d.z);
    const Point3 p{centre.x + d.x * share, centre.y + d.y * share, centre.z + d.z * share};
    if (!floats) return p;
    return {static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)};
  }
  std::vector<Point3> draw_all(std::mt19937_64& random, double spread) const {
    std::vector<Point3> points;
    for (int i = 0; i < 64; ++i) points.push_back(draw(random, spread));
    return points;
  }
};

const SphereFamily kFamilies[] = {{{0, 0, 0}, 1, 0.01, false},
                                  {{0, 0, 0}, 1, 0.01, true},
                                  {{1000, -200, 3}, 1, 0.1, false},
                                  {{0.1, 0.2, 0.3}, 0x1p-19, 0.01, false},
                                  {{0, 0, 0}, 0x1p90, 0.01, false}};

TEST(SphereFit, FindsTheSphereUpToTheRoundingOfItsPoints) {
  std::mt19937_64 random(kSeed);
  for (const SphereFamily& family : kFamilies) {
    const auto points = family.draw_all(random, 2);
    const auto sphere = fit_sphere(points);
    ASSERT_TRUE(sphere.has_value());
    const double reach = family.radius + std::abs(family.centre.x) + std::abs(family.centre.y);
    const double rounding = reach * (family.floats ? 0x1p-24 : 0x1p-53);
    const Heights heights = heights_over(*sphere, points);
    EXPECT_LT(heights.high - heights.low, 16 * rounding * family.radius);
  }
}

TEST(SphereFit, OfAPlaneIsNothing) {
  std::mt19937_64 random(kSeed);
  std::vector<Point3> points;
  for (int i = 0; i < 64; ++i) {
    const Point3 p = families::random_point(random);
    points.push_back({p.x, p.y, 0.25 * p.x + 0.5});
  }
  EXPECT_FALSE(fit_sphere(points).has_value());
  EXPECT_FALSE(fit_sphere({points.data(), 3}).has_value());
}

TEST(SphereHeight, IsWithinItsErrorOfTheExactOne) {
  std::mt19937_64 random(kSeed);
  for (const SphereFamily& family : kFamilies) {
    const auto points = family.draw_all(random, 2);
    const Sphere sphere = fit_sphere(points).value();
    for (const Point3& p : points) {
      const double height = height_over(sphere, p);
      const Rational exact = squared_distance(p, sphere.centre) - Rational(sphere.squared_radius);
      ASSERT_LE(abs(Rational(height) - exact), Rational(height_error(sphere, height)));
    }
  }
}

/// The powers of 16 points as the cut alone knows them.
PointPowers powers_by_cut(const Sphere& sphere, const SphereCut& cut,
                          const std::array<Point3, 16>& points) {
  std::array<double, 16> x{};
  std::array<double, 16> y{};
  std::array<double, 16> z{};
  LeafHeights heights{};
  PointPowers powers{};
  for (std::size_t i = 0; i < 16; ++i) {
    x[i] = points[i].x;
    y[i] = points[i].y;
    z[i] = points[i].z;
    heights[i] = height_over(sphere, points[i]);
  }
  powers.error.fill(kInfinity);
  sharpen_powers(sphere, cut, {x.data(), y.data(), z.data()}, heights, powers);
  return powers;
}

TEST(SphereCut, TellsPointsOfTheSphereInsideFromOutsideWithinItsError) {
  std::mt19937_64 random(kSeed);
  for (const SphereFamily& family : kFamilies) {
    const Sphere sphere = fit_sphere(family.draw_all(random, 2)).value();
    int told = 0;
    int asked = 0;
    for (int run = 0; run < 40; ++run) {
      const double spread = run % 2 == 0 ? family.near : 2;
      Corners corners;
      for (Point3& p : corners) p = family.draw(random, spread);
      const SphereCut cut = cut_sphere(sphere, corners);
      if (!cut.is_known()) continue;
      std::array<Point3, 16> points;
      for (std::size_t i = 0; i < 16; ++i) points[i] = family.draw(random, i < 8 ? spread : 2);
      points[15] = {family.centre.x, family.centre.y, family.centre.z};
      const PointPowers powers = powers_by_cut(sphere, cut, points);
      for (std::size_t i = 0; i < 16; ++i) {
        const Rational exact = exact_power(corners, points[i]);
        ASSERT_LE(abs(Rational(powers.power[i]) - exact), Rational(powers.error[i]));
        ASSERT_LE(powers.least, powers.power[i] - powers.error[i]);
        ++asked;
        told += std::abs(powers.power[i]) > powers.error[i] ? 1 : 0;
      }
    }
    EXPECT_GT(asked, 300);
    EXPECT_GT(told, asked * 9 / 10);
  }
}

TEST(SphereCut, OfAFlatTetrahedronIsNotKnown) {
  const Sphere sphere{{0, 0, 0}, 1};
  EXPECT_FALSE(
      cut_sphere(sphere, {{{1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0x1p-55}}}).is_known());
}

}  // namespace
}  // namespace stream_recon
