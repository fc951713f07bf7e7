// The circle filter of flat sides against integers of unlimited size.

#include "spatial/flat_circle.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <random>
#include <string>

#include "tests/exact_reference.h"

namespace stream_recon {
namespace {

using reference::Integer;

/// Turned so that the plane is square to another axis.
Point3 turned(const Point3& p, int axis) {
  return axis == 0 ? Point3{p.z, p.x, p.y} : axis == 1 ? Point3{p.y, p.z, p.x} : p;
}

/// Positive outside the circle of the first three, in the plane z = const.
int outside(const std::array<Point3, 4>& p) {
  const reference::Vector c = reference::to_vector(p[0]);
  std::array<reference::Vector, 3> d;
  std::array<Integer, 3> lift;
  for (std::size_t i = 0; i < 3; ++i) {
    d[i] = reference::minus(reference::to_vector(p[i + 1]), c);
    lift[i] = d[i][0] * d[i][0] + d[i][1] * d[i][1];
  }
  const Integer area = d[0][0] * d[1][1] - d[0][1] * d[1][0];
  const Integer a = lift[0] * d[1][1] - lift[1] * d[0][1];
  const Integer b = lift[1] * d[0][0] - lift[0] * d[1][0];
  const Integer determinant = area * lift[2] - a * d[2][0] - b * d[2][1];
  return determinant.sign() * area.sign();
}

struct Tally {
  int outside = 0;  ///< in truth
  int known = 0;
};

void check(const std::array<Point3, 4>& p, Tally& tally) {
  const int truth = outside(p);
  tally.outside += truth > 0 ? 1 : 0;
  for (int axis = 0; axis < 3; ++axis) {
    const auto circle =
        FlatCircle::of({turned(p[0], axis), turned(p[1], axis), turned(p[2], axis)});
    if (!circle) continue;
    const bool is_outside = circle->is_surely_outside(turned(p[3], axis));
    EXPECT_FALSE(is_outside && truth <= 0);
    tally.known += axis == 2 && is_outside ? 1 : 0;
  }
}

TEST(FlatCircle, KnowsNearlyAllRandomPointsOutsideAndIsNeverWrong) {
  const std::uint64_t seed = 71;
  SCOPED_TRACE("seed " + std::to_string(seed));
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> place(-1, 1);
  Tally tally;
  for (int i = 0; i < 20000; ++i) {
    std::array<Point3, 4> p;
    for (Point3& q : p) q = {place(random), place(random), 0.7};
    check(p, tally);
  }
  EXPECT_GT(tally.known, tally.outside * 99 / 100);
}

TEST(FlatCircle, IsNeverWrongOnLatticesWhereMostPointsAreOnCircles) {
  std::mt19937_64 random(73);
  std::uniform_int_distribution<int> place(0, 6);
  Tally tally;
  for (int i = 0; i < 50000; ++i) {
    std::array<Point3, 4> p;
    for (Point3& q : p) q = {0.1 * place(random), 0.3 + 0.1 * place(random), -2};
    check(p, tally);
  }
  EXPECT_GT(tally.known, tally.outside * 8 / 10);
}

TEST(FlatCircle, IsNeverWrongBesideTheCircleByRoundings) {
  std::mt19937_64 random(79);
  std::uniform_real_distribution<double> angle(0, 6.3);
  std::uniform_int_distribution<int> steps(-3, 3);
  Tally tally;
  for (const double far : {0.0, 1.0, 1e6}) {
    for (int i = 0; i < 10000; ++i) {
      std::array<Point3, 4> p;
      for (Point3& q : p) {
        const double at = angle(random);
        q = {far + std::cos(at), std::sin(at), 5};
      }
      for (int k = steps(random); k > 0; --k) p[3].x = std::nextafter(p[3].x, 1e9);
      check(p, tally);
    }
  }
  EXPECT_GT(tally.outside, 1000);
}

TEST(FlatCircle, LiesInItsBallUpToTheTruth) {
  std::mt19937_64 random(83);
  std::uniform_real_distribution<double> place(-1, 1);
  int known = 0;
  for (int i = 0; i < 20000; ++i) {
    std::array<Point3, 4> p;
    for (Point3& q : p) q = {1e3 + place(random), place(random), 0.7};
    if (outside(p) > 0) continue;
    for (int axis = 0; axis < 3; ++axis) {
      const auto circle =
          FlatCircle::of({turned(p[0], axis), turned(p[1], axis), turned(p[2], axis)});
      if (!circle || !circle->ball()) continue;
      const auto [centre, radius] = *circle->ball();
      for (const Point3& q : p) {
        const Point3 at = turned(q, axis);
        EXPECT_LE(std::hypot(at.x - centre.x, at.y - centre.y, at.z - centre.z),
                  radius * (1 + 1e-15));
      }
      EXPECT_EQ(circle->level(), 0.7);
      ++known;
    }
  }
  EXPECT_GT(known, 10000);
}

TEST(FlatCircle, SaysNothingOfOtherPlanes) {
  const auto circle = FlatCircle::of({{{0, 0, 1}, {1, 0, 1}, {0, 1, 1}}});
  ASSERT_TRUE(circle.has_value());
  EXPECT_TRUE(circle->is_surely_outside({5, 5, 1}));
  EXPECT_FALSE(circle->is_surely_outside({0.5, 0.5, 1}));
  EXPECT_FALSE(circle->is_surely_outside({1, 1, 1}));
  EXPECT_FALSE(circle->is_surely_outside({5, 5, std::nextafter(1.0, 2.0)}));
  EXPECT_FALSE(FlatCircle::of({{{0, 0, 1}, {1, 0, 1}, {0, 1, 1.5}}}).has_value());
  EXPECT_FALSE(FlatCircle::of({{{0, 0, 1}, {1, 0, 1}, {2, 0, 1}}}).has_value());
  EXPECT_FALSE(FlatCircle::of({{{0, 0, 1}, {1e-200, 0, 1}, {0, 1e-200, 1}}}).has_value());
}

}  // namespace
}  // namespace stream_recon
