// The balls of a facet against rational arithmetic, and the two criteria on what they are made of.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <random>
#include <string>

#include "spatial/alpha_facet.h"
#include "spatial/facet_balls.h"
#include "spatial/gamma_facet.h"
#include "tests/point_families.h"

namespace stream_recon {
namespace {

using Rational = boost::multiprecision::cpp_rational;
using Vector = std::array<Rational, 3>;
using Facet = std::array<Point3, 3>;

Vector vector_to(const Point3& p, const Point3& origin) {
  return {Rational(p.x) - Rational(origin.x), Rational(p.y) - Rational(origin.y),
          Rational(p.z) - Rational(origin.z)};
}

Rational determinant(const Vector& a, const Vector& b, const Vector& c) {
  return a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) +
         a[2] * (b[0] * c[1] - b[1] * c[0]);
}

Rational dot(const Vector& a, const Vector& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

Rational orientation(const Facet& facet, const Point3& apex) {
  return determinant(vector_to(facet[1], facet[0]), vector_to(facet[2], facet[0]),
                     vector_to(apex, facet[0]));
}

/// Centre of the sphere through the four points relative to facet[0], by Cramer's rule on the
/// equations 2 p.x = |p|^2: another way than the one under test.
Vector centre(const Facet& facet, const Point3& apex) {
  const std::array<Vector, 3> rows{vector_to(facet[1], facet[0]), vector_to(facet[2], facet[0]),
                                   vector_to(apex, facet[0])};
  const Rational all = determinant(rows[0], rows[1], rows[2]);
  Vector result;
  for (int axis = 0; axis < 3; ++axis) {
    auto replaced = rows;
    for (int row = 0; row < 3; ++row) replaced[row][axis] = dot(rows[row], rows[row]) / 2;
    result[axis] = determinant(replaced[0], replaced[1], replaced[2]) / all;
  }
  return result;
}

/// The definition of the gamma facet, word by word, in rational numbers.
bool is_gamma_by_definition(const Facet& facet, const Point3& one, const Point3& two) {
  const Vector x1 = centre(facet, one);
  const Vector x2 = centre(facet, two);
  const Rational r1 = dot(x1, x1);
  const Rational r2 = dot(x2, x2);
  const Vector apart{x1[0] - x2[0], x1[1] - x2[1], x1[2] - x2[2]};
  return (dot(apart, apart) - r1 - r2) * 1000000000 > r1 + r2;
}

/// Five points whose last two lie on different sides of the first three.
struct Pair {
  Facet facet;
  Point3 one, two;
};

bool draw_pair(const families::Family& family, std::mt19937_64& random, Pair& pair) {
  for (int attempt = 0; attempt < 200; ++attempt) {
    for (Point3& p : pair.facet) p = family.draw(random);
    pair.one = family.draw(random);
    pair.two = family.draw(random);
    const Rational first = orientation(pair.facet, pair.one);
    const Rational second = orientation(pair.facet, pair.two);
    if (first != 0 && second != 0 && (first < 0) != (second < 0)) return true;
  }
  return false;
}

TEST(GammaFacet, AgreesWithTheDefinitionInRationalNumbers) {
  for (const families::Family& family : families::all()) {
    std::mt19937_64 random(7);
    for (int i = 0; i < 100; ++i) {
      Pair pair;
      if (!draw_pair(family, random, pair)) continue;
      EXPECT_EQ(GammaCriterion(90).takes(facet_balls(pair.facet, pair.one, pair.two)),
                is_gamma_by_definition(pair.facet, pair.one, pair.two))
          << family.name << ", seed 7, pair " << i;
    }
  }
}

TEST(FacetBalls, HeightsAndRadiiAgreeWithRationalNumbersHoweverFlatTheTetrahedron) {
  std::mt19937_64 random(11);
  for (int flatness = 0; flatness <= 50; ++flatness) {
    for (int i = 0; i < 40; ++i) {
      const Facet facet{families::random_point(random), families::random_point(random),
                        families::random_point(random)};
      Point3 apex = families::random_point(random);
      const double squash = std::ldexp(1.0, -flatness);
      const auto blend = [&](double a, double b, double c, double d) {
        return 0.3 * a + 0.3 * b + 0.4 * c + squash * d;
      };
      apex = {blend(facet[0].x, facet[1].x, facet[2].x, apex.x),
              blend(facet[0].y, facet[1].y, facet[2].y, apex.y),
              blend(facet[0].z, facet[1].z, facet[2].z, apex.z)};
      if (orientation(facet, apex) == 0) continue;
      const FacetBalls balls = hull_facet_balls(facet, apex);
      const Vector x = centre(facet, apex);
      const double radius = std::sqrt(dot(x, x).convert_to<double>());
      EXPECT_NEAR(std::hypot(balls.radius, balls.height[0]), radius, 1e-9 * radius)
          << "flatness " << flatness << ", seed 11, tetrahedron " << i;
    }
  }
}

TEST(FacetBalls, DoNotChangeWithTheScaleAsLongAsDoublesLast) {
  std::mt19937_64 random(3);
  Pair pair;
  ASSERT_TRUE(draw_pair(families::all().front(), random, pair));
  const FacetBalls balls = facet_balls(pair.facet, pair.one, pair.two);
  for (int exponent : {-1000, -300, -100, 100, 300, 900}) {
    const auto scaled = [exponent](const Point3& p) {
      return Point3{std::ldexp(p.x, exponent), std::ldexp(p.y, exponent),
                    std::ldexp(p.z, exponent)};
    };
    const Facet facet{scaled(pair.facet[0]), scaled(pair.facet[1]), scaled(pair.facet[2])};
    const FacetBalls other = facet_balls(facet, scaled(pair.one), scaled(pair.two));
    EXPECT_NEAR(std::ldexp(other.radius, -exponent) / balls.radius, 1, 1e-12) << exponent;
    for (int i : {0, 1}) {
      EXPECT_NEAR(std::ldexp(other.height[i], -exponent) / balls.height[i], 1, 1e-9) << exponent;
    }
  }
}

TEST(FacetBalls, AreCertainForNeedlesAndDenormals) {
  const double tiny = std::numeric_limits<double>::denorm_min();
  const Facet facet{Point3{0, 0, 0}, Point3{8 * tiny, 0, 0}, Point3{0, 8 * tiny, 0}};
  const FacetBalls denormal = hull_facet_balls(facet, {0, 0, 8 * tiny});
  EXPECT_NEAR(denormal.height[0] / tiny, 4, 1);

  const Facet needle{Point3{0, 0, 0}, Point3{1, 0, 0}, Point3{0.5, 0x1p-40, 0}};
  const FacetBalls balls = hull_facet_balls(needle, {0.5, 0, 0x1p-41});
  EXPECT_NEAR(balls.radius * 0x1p-37, 1, 1e-9);
  const Vector x = centre(needle, {0.5, 0, 0x1p-41});
  EXPECT_NEAR(balls.height[0] / x[2].convert_to<double>(), 1, 1e-9);
}

TEST(GammaFacet, TiesAtARightAngleAreNotTaken) {
  const FacetBalls right{1, {1, 1}};
  EXPECT_DOUBLE_EQ(gamma_angle(right), 90);
  EXPECT_FALSE(GammaCriterion(90).takes(right));
  EXPECT_FALSE(GammaCriterion(90).takes({1, {1, 1 + 1e-10}}));
  EXPECT_TRUE(GammaCriterion(90).takes({1, {1, 1 + 1e-8}}));
  EXPECT_FALSE(GammaCriterion(90).takes({1, {1e-10, FacetBalls::kHalfSpace}}));
  EXPECT_TRUE(GammaCriterion(90).takes({1, {1e-8, FacetBalls::kHalfSpace}}));
  EXPECT_FALSE(GammaCriterion(90).takes({1, {-1, FacetBalls::kHalfSpace}}));
}

TEST(GammaFacet, ThresholdsMoveTheAngle) {
  const FacetBalls sixty{1, {std::sqrt(3.0), std::sqrt(3.0)}};
  EXPECT_NEAR(gamma_angle(sixty), 60, 1e-6);
  EXPECT_TRUE(GammaCriterion(60.001).takes(sixty));
  EXPECT_FALSE(GammaCriterion(59.999).takes(sixty));
  const FacetBalls wide{1, {-0.5, 0.75}};
  EXPECT_GT(gamma_angle(wide), 90);
  EXPECT_TRUE(GammaCriterion(180).takes(wide));
  EXPECT_TRUE(GammaCriterion(45.001).takes({1, {1, FacetBalls::kHalfSpace}}));
  EXPECT_FALSE(GammaCriterion(44.999).takes({1, {1, FacetBalls::kHalfSpace}}));
}

TEST(AlphaFacet, RadiiOfEmptyBallsAreAnInterval) {
  const FacetBalls gabriel{3, {4, 4}};
  EXPECT_EQ(empty_ball_radii(gabriel).smallest, 3);
  EXPECT_EQ(empty_ball_radii(gabriel).largest, 5);
  const FacetBalls one_sided{3, {-4, 1e3}};
  EXPECT_EQ(empty_ball_radii(one_sided).smallest, 5);
  const FacetBalls hull{3, {-4, FacetBalls::kHalfSpace}};
  EXPECT_EQ(empty_ball_radii(hull).smallest, 5);
  EXPECT_TRUE(std::isinf(empty_ball_radii(hull).largest));
}

TEST(AlphaFacet, IsTakenAtBothEndsOfTheInterval) {
  const FacetBalls gabriel{3, {4, 4}};
  EXPECT_FALSE(is_alpha_facet(gabriel, 2.999));
  EXPECT_TRUE(is_alpha_facet(gabriel, 3));
  EXPECT_TRUE(is_alpha_facet(gabriel, 5));
  EXPECT_FALSE(is_alpha_facet(gabriel, 5.001));
  EXPECT_TRUE(is_alpha_facet({3, {4, FacetBalls::kHalfSpace}}, 1e100));
}

}  // namespace
}  // namespace stream_recon
