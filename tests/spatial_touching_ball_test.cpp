// Balls through four points against rational arithmetic, and against each other.

#include "spatial/touching_ball.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <set>
#include <tuple>
#include <vector>

#include "spatial/vector.h"
#include "tests/exact_centre.h"

namespace stream_recon {
namespace {

void expect_accurate(const Corners& corners) {
  const auto exact = exact_centre(corners);
  if (!exact) return;
  const TouchingBall ball = touching_ball(corners);
  ASSERT_TRUE(ball.is_finite());
  const Rational square = dot(*exact, *exact);
  const Rational radius(ball.radius);
  const Rational one_off = square * Rational(0x1p-50);
  EXPECT_LE(abs(radius * radius - square), one_off);
  const std::array<double, 3> found{ball.centre.x, ball.centre.y, ball.centre.z};
  const std::array<double, 3> first{corners[0].x, corners[0].y, corners[0].z};
  for (int axis = 0; axis < 3; ++axis) {
    const Rational expected = (*exact)[axis] + Rational(first[axis]);
    const Rational error = abs(Rational(found[axis]) - expected);
    const Rational allowed = abs(expected) * Rational(0x1.001p-53) + radius * Rational(0x1p-58);
    EXPECT_LE(error, allowed) << axis;
  }
}

Corners random_corners(std::mt19937_64& random, const Point3& flatness, double at) {
  std::uniform_real_distribution<double> one(-1, 1);
  Corners corners;
  for (Point3& p : corners) {
    p = {at + flatness.x * one(random), at + flatness.y * one(random), flatness.z * one(random)};
  }
  return corners;
}

TEST(TouchingBalls, AreRoundedFromTheExactOnes) {
  std::mt19937_64 random(5);
  for (int i = 0; i < 300; ++i) {
    expect_accurate(random_corners(random, {1, 1, 1}, 0));
    expect_accurate(random_corners(random, {1, 1e-4, 1}, 100));
    expect_accurate(random_corners(random, {1, 1, 1e-9}, 1));
  }
}

TEST(TouchingBalls, OfTheFlattestTetrahedraAreExactToo) {
  std::mt19937_64 random(6);
  for (int i = 0; i < 20; ++i) {
    expect_accurate(random_corners(random, {1, 1, 1e-30}, 0));
    expect_accurate(random_corners(random, {1, 1, 1e-100}, 0));
    // Points of a plane, but for their last places.
    Corners corners = random_corners(random, {1, 1, 0}, 0);
    for (Point3& p : corners) p.z = p.x * 3 + p.y / 7;
    expect_accurate(corners);
  }
}

TEST(TouchingBalls, AreTheSameAtEveryScale) {
  std::mt19937_64 random(7);
  const Corners corners = random_corners(random, {1, 1, 1}, 10);
  const TouchingBall ball = touching_ball(corners);
  for (const double scale : {0x1p1000, 0x1p-800}) {
    Corners other = corners;
    for (Point3& p : other) p = scaled(p, scale);
    const TouchingBall there = touching_ball(other);
    EXPECT_EQ(there.centre, scaled(ball.centre, scale));
    EXPECT_EQ(there.radius, ball.radius * scale);
    EXPECT_EQ(there.separation, ball.separation);
  }
}

TEST(TouchingBalls, ThatAreTooLargeForDoublesSaySo) {
  const Corners corners{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0x1p-600}}};
  EXPECT_TRUE(touching_ball(corners).is_finite()) << "a square: its corners lie on one circle";
  const Corners larger{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1.5, 0x1p-300}}};
  const TouchingBall ball = touching_ball(larger);
  ASSERT_TRUE(ball.is_finite());
  EXPECT_NEAR(std::log2(ball.radius), 300, 2);
  Corners huge = larger;
  for (Point3& p : huge) p = scaled(p, 0x1p900);
  EXPECT_FALSE(touching_ball(huge).is_finite());
}

/// Points of a sphere of integers, moved and shrunk without rounding.
std::vector<Point3> sphere_points(int square, const Point3& to, double by) {
  std::vector<Point3> points;
  for (int x = -20; x <= 20; ++x) {
    for (int y = -20; y <= 20; ++y) {
      for (int z = -20; z <= 20; ++z) {
        if (x * x + y * y + z * z != square) continue;
        points.push_back({to.x + x * by, to.y + y * by, to.z + z * by});
      }
    }
  }
  return points;
}

using Bits = std::tuple<double, double, double, double>;

TEST(TouchingBalls, OfOneSphereAreTheSameBits) {
  for (const double by : {1.0, 0x1p-9, 3.0}) {
    const std::vector<Point3> points = sphere_points(101, {1000.5, -3, 0x1p-20}, by);
    ASSERT_GT(points.size(), 50U);
    std::mt19937_64 random(8);
    std::set<Bits> balls;
    for (int i = 0; i < 500; ++i) {
      Corners corners;
      for (Point3& p : corners) p = points[random() % points.size()];
      if (!exact_centre(corners)) continue;
      const TouchingBall ball = touching_ball(corners);
      balls.insert({ball.centre.x, ball.centre.y, ball.centre.z, ball.radius});
    }
    EXPECT_EQ(balls.size(), 1U);
    EXPECT_EQ(balls.count({1000.5, -3, 0x1p-20, std::sqrt(101.0) * by}), 1U);
  }
}

TEST(TouchingBalls, OfFourPointsOfACircleAndOneMoreAreTheSameBitsWhereTheyAreRounded) {
  // Centres at sixths and the like: no double.
  std::mt19937_64 random(9);
  int checked = 0;
  for (int i = 0; i < 20000 && checked < 100; ++i) {
    std::array<Point3, 5> p;
    for (Point3& q : p) q = {double(random() % 7), double(random() % 7), double(random() % 5)};
    const Corners one{p[0], p[1], p[2], p[3]};
    const Corners other{p[4], p[3], p[1], p[2]};
    const auto a = exact_centre(one);
    const auto b = exact_centre(other);
    if (!a || !b) continue;
    bool is_same = p[0] != p[4];
    const Vector between = vector_to(p[4], p[0]);
    for (int axis = 0; axis < 3; ++axis) is_same &= (*a)[axis] == (*b)[axis] + between[axis];
    if (!is_same) continue;
    ++checked;
    const TouchingBall left = touching_ball(one);
    const TouchingBall right = touching_ball(other);
    EXPECT_EQ(left.centre, right.centre);
    EXPECT_EQ(left.radius, right.radius);
  }
  EXPECT_GE(checked, 100);
}

TEST(TouchingBalls, HaveTheLargestAngleBetweenTwoOfTheirPoints) {
  const double h = std::sqrt(0.5);
  EXPECT_FLOAT_EQ(touching_ball({{{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}).separation, 180);
  EXPECT_FLOAT_EQ(touching_ball({{{1, 0, 0}, {0, 1, 0}, {h, h, 0}, {h, 0, h}}}).separation, 90);
  std::mt19937_64 random(10);
  const Corners corners = random_corners(random, {1, 1, 1}, 0);
  const TouchingBall ball = touching_ball(corners);
  double largest = 0;
  for (const Point3& p : corners) {
    for (const Point3& q : corners) {
      const double cosine = stream_recon::dot(minus(p, ball.centre), minus(q, ball.centre)) /
                            (ball.radius * ball.radius);
      largest = std::max(largest, std::acos(std::clamp(cosine, -1.0, 1.0)));
    }
  }
  EXPECT_NEAR(ball.separation, largest * 180 / std::acos(-1.0), 1e-4);
}

}  // namespace
}  // namespace stream_recon
