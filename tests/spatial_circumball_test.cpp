// Circumscribed balls and the powers of points against rational arithmetic.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include "spatial/ball_points.h"
#include "spatial/circumball.h"
#include "tests/exact_centre.h"
#include "tests/point_families.h"

namespace stream_recon {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr unsigned kSeeds = 40;

/// Six volumes over the product of the edges at the first corner: 1 at most.
double shape(const Corners& corners) {
  const std::array<Vector, 3> rows{vector_to(corners[1], corners[0]),
                                   vector_to(corners[2], corners[0]),
                                   vector_to(corners[3], corners[0])};
  const Rational all = determinant(rows);
  const Rational edges = dot(rows[0], rows[0]) * dot(rows[1], rows[1]) * dot(rows[2], rows[2]);
  return std::sqrt(Rational(all * all / edges).convert_to<double>());
}

Corners draw(const families::Family& family, std::mt19937_64& random) {
  return {family.draw(random), family.draw(random), family.draw(random), family.draw(random)};
}

/// The fourth corner is off the plane of the others by about 10^-flatness.
Corners sliver(int flatness, std::mt19937_64& random) {
  Corners c = draw(families::all().front(), random);
  const double off = std::pow(10.0, -flatness);
  const auto blend = [off](double p, double q, double r, double s) {
    return 0.4 * p + 0.9 * q - 0.3 * r + off * s;
  };
  c[3] = {blend(c[0].x, c[1].x, c[2].x, c[3].x), blend(c[0].y, c[1].y, c[2].y, c[3].y),
          blend(c[0].z, c[1].z, c[2].z, c[3].z)};
  return c;
}

void expect_centre_within_error(const Corners& corners, const Vector& centre) {
  const Circumball ball = circumball(corners);
  ASSERT_EQ(ball.origin, corners[0]);
  ASSERT_GE(ball.centre_error, 0);
  if (std::isinf(ball.centre_error)) {
    ASSERT_LT(shape(corners), 1e-30);
    return;
  }
  const Vector off{centre[0] - Rational(ball.centre.x), centre[1] - Rational(ball.centre.y),
                   centre[2] - Rational(ball.centre.z)};
  const Rational error(ball.centre_error);
  ASSERT_LE(dot(off, off), error * error)
      << "centre_error " << ball.centre_error << ", radius " << ball.radius();
}

std::string trace(const std::string& name, unsigned seed) {
  return name + ", seed " + std::to_string(seed);
}

TEST(Circumball, ExactCentreIsWithinTheErrorOnAllFamilies) {
  for (const families::Family& family : families::all()) {
    for (unsigned seed = 0; seed < kSeeds; ++seed) {
      SCOPED_TRACE(trace(family.name, seed));
      std::mt19937_64 random(seed);
      const Corners corners = draw(family, random);
      const auto centre = exact_centre(corners);
      if (!centre) continue;
      ASSERT_NO_FATAL_FAILURE(expect_centre_within_error(corners, *centre));
    }
  }
}

TEST(Circumball, ExactCentreIsWithinTheErrorHoweverFlatTheTetrahedron) {
  for (int flatness = 0; flatness <= 16; ++flatness) {
    for (unsigned seed = 0; seed < kSeeds; ++seed) {
      SCOPED_TRACE(trace("flatness " + std::to_string(flatness), seed));
      std::mt19937_64 random(seed);
      const Corners corners = sliver(flatness, random);
      const auto centre = exact_centre(corners);
      if (!centre) continue;
      ASSERT_NO_FATAL_FAILURE(expect_centre_within_error(corners, *centre));
    }
  }
}

TEST(Circumball, ExactCentreIsWithinTheErrorAtEveryScaleOrTheErrorIsInfinite) {
  for (const int exponent : {-350, -300, -260, -200, 200, 260, 300, 350}) {
    SCOPED_TRACE(trace("scale 2^" + std::to_string(exponent), 1));
    std::mt19937_64 random(1);
    Corners corners = draw(families::all().front(), random);
    const double s = std::ldexp(1.0, exponent);
    for (Point3& p : corners) p = {p.x * s, p.y * s, p.z * s};
    if (std::isinf(circumball(corners).centre_error)) continue;
    EXPECT_NO_FATAL_FAILURE(expect_centre_within_error(corners, *exact_centre(corners)));
  }
}

TEST(Circumball, ErrorIsTinyUnlessTheTetrahedronIsFlat) {
  for (unsigned seed = 0; seed < 1000; ++seed) {
    SCOPED_TRACE(trace("random", seed));
    std::mt19937_64 random(seed);
    const Corners corners = sliver(static_cast<int>(seed % 16), random);
    if (!exact_centre(corners)) continue;
    const Circumball ball = circumball(corners);
    const double share = shape(corners) > 0.1 ? 1e-12 : 1e-8;
    ASSERT_LE(ball.centre_error, share * ball.radius());
  }
  const Circumball corner = circumball({Point3{}, {2, 0, 0}, {0, 2, 0}, {0, 0, 2}});
  EXPECT_EQ(corner.centre, (Point3{1, 1, 1}));
  EXPECT_LT(corner.centre_error, 1e-13);
}

/// Sixteen points in columns, as leaves have them.
struct Leaf {
  std::array<double, PointPowers::kPoints> x, y, z;

  Point3 point(std::size_t i) const { return {x[i], y[i], z[i]}; }
  void set(std::size_t i, const Point3& p) { x[i] = p.x, y[i] = p.y, z[i] = p.z; }
  PointColumns columns() const { return {x.data(), y.data(), z.data()}; }
};

void expect_powers_within_error(const Corners& corners, const Vector& centre, const Leaf& leaf) {
  PointPowers powers;
  powers_of_points(circumball(corners), leaf.columns(), powers);
  double least = kInfinity;
  for (std::size_t i = 0; i < PointPowers::kPoints; ++i) {
    if (!is_finite(leaf.point(i))) {
      ASSERT_TRUE(std::isnan(powers.power[i])) << "point " << i;
      continue;
    }
    least = std::fmin(least, powers.power[i] - powers.error[i]);
    if (!std::isfinite(powers.error[i])) continue;
    const Vector q = vector_to(leaf.point(i), corners[0]);
    const Rational off = dot(q, q) - 2 * dot(q, centre) - Rational(powers.power[i]);
    ASSERT_LE(abs(off), Rational(powers.error[i])) << "point " << i;
  }
  ASSERT_EQ(powers.least, least);
}

TEST(PointPowers, ExactOnesAreWithinTheErrorAndTheLeastIsFound) {
  for (const families::Family& family : families::all()) {
    for (unsigned seed = 0; seed < kSeeds; ++seed) {
      SCOPED_TRACE(trace(family.name, seed));
      std::mt19937_64 random(seed);
      const Corners corners = draw(family, random);
      const auto centre = exact_centre(corners);
      if (!centre) continue;
      Leaf leaf;
      for (std::size_t i = 0; i < PointPowers::kPoints; ++i) leaf.set(i, family.draw(random));
      leaf.set(seed % 16, corners[1]);
      if (seed % 3 == 0) leaf.x[random() % 16] = kNan;
      if (seed % 3 == 0) leaf.y[random() % 16] = kNan;
      if (seed % 3 == 0) leaf.z[random() % 16] = kNan;
      ASSERT_NO_FATAL_FAILURE(expect_powers_within_error(corners, *centre, leaf));
    }
  }
}

TEST(PointPowers, ExactOnesAreWithinTheErrorNextToSlivers) {
  for (int flatness = 0; flatness <= 16; ++flatness) {
    for (unsigned seed = 0; seed < kSeeds; ++seed) {
      SCOPED_TRACE(trace("flatness " + std::to_string(flatness), seed));
      std::mt19937_64 random(seed);
      const Corners corners = sliver(flatness, random);
      const auto centre = exact_centre(corners);
      if (!centre) continue;
      Leaf leaf;
      for (std::size_t i = 0; i < PointPowers::kPoints; ++i) {
        leaf.set(i, i % 2 ? families::nudged(corners[i / 2 % 4], random)
                          : families::random_point(random));
      }
      ASSERT_NO_FATAL_FAILURE(expect_powers_within_error(corners, *centre, leaf));
    }
  }
}

TEST(PointPowers, LeastOfNoPointsIsInfinite) {
  Leaf leaf;
  for (std::size_t i = 0; i < PointPowers::kPoints; ++i) leaf.set(i, {kNan, kNan, kNan});
  PointPowers powers;
  const Circumball ball = circumball({Point3{}, {2, 0, 0}, {0, 2, 0}, {0, 0, 2}});
  powers_of_points(ball, leaf.columns(), powers);
  EXPECT_EQ(powers.least, kInfinity);
}

}  // namespace
}  // namespace stream_recon
