// Evidence against the balls themselves, computed another way: by their heights over the facet.
#include "spatial/side_evidence.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "spatial/circumball.h"
#include "spatial/facet_balls.h"
#include "spatial/vector.h"

namespace stream_recon {
namespace {

constexpr std::uint64_t kSeeds = 2000;

/// A facet at the origin with an apex on either side.
struct RandomFacet {
  std::array<Point3, 3> corners{};
  Point3 below;
  Point3 above;

  explicit RandomFacet(std::uint64_t seed) {
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> one(-1, 1);
    const auto point = [&](double low, double high) {
      return Point3{one(random), one(random), low + (high - low) * std::abs(one(random))};
    };
    corners = {Point3{}, point(0, 0), point(0, 0)};
    if (cross(corners[1], corners[2]).z < 0) std::swap(corners[1], corners[2]);
    below = point(-2, -0.1);
    above = point(0.1, 2);
  }

  Point3 centre(const Point3& apex) const {
    return circumball({corners[0], corners[1], corners[2], apex}).centre;
  }
  /// Only those that are Delaunay.
  bool is_locally_delaunay() const {
    const Point3 z = centre(below);
    return length(minus(above, z)) > length(z);
  }
};

double plain_odds(double strength) {
  return (1 + strength) / (1 - strength);
}

/// In terms of the heights of the centres over the facet.
double plain_strength(const FacetBalls& balls, double spacing) {
  const double f = balls.height[0] / balls.radius;
  const bool is_hull = balls.height[1] == FacetBalls::kHalfSpace;
  const double s = is_hull ? 0 : balls.height[1] / balls.radius;
  const double cosine =
      is_hull ? f / std::hypot(1, f) : (f * s - 1) / (std::hypot(1, f) * std::hypot(1, s));
  const double window = balls.radius * std::hypot(1, std::min({f, s, 0.0}));
  return -cosine * std::min(1.0, window / (0.42 * spacing));
}

TEST(SideEvidence, OfAFacetIsThatOfTheHeightsOfItsBalls) {
  int seen = 0;
  for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    const RandomFacet facet(seed);
    if (!facet.is_locally_delaunay()) continue;
    ++seen;
    const FacetBalls balls = facet_balls(facet.corners, facet.below, facet.above);
    const FacetSides sides{.corners = {facet.corners[1], facet.corners[2]},
                           .centres = {facet.centre(facet.below), facet.centre(facet.above)}};
    for (const double spacing : {0.01, 1.0, 30.0}) {
      const double expected = plain_odds(plain_strength(balls, spacing));
      EXPECT_NEAR(same_side_evidence(sides, spacing), expected, 1e-6 * expected) << spacing;
    }
  }
  EXPECT_GT(seen, 300);
}

TEST(SideEvidence, OfAHullFacetIsThatOfAHalfSpace) {
  for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    const RandomFacet facet(seed);
    const FacetBalls balls = hull_facet_balls(facet.corners, facet.below);
    const FacetSides sides{.corners = {facet.corners[1], facet.corners[2]},
                           .centres = {facet.centre(facet.below), {0, 0, 7}},
                           .is_hull = true};
    for (const double spacing : {0.01, 30.0}) {
      const double expected = plain_odds(plain_strength(balls, spacing));
      EXPECT_NEAR(same_side_evidence(sides, spacing), expected, 1e-6 * expected) << spacing;
    }
  }
}

TEST(SideEvidence, IsTheSameToTheBitFromEitherSide) {
  for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
    const RandomFacet facet(seed);
    FacetSides sides{.corners = {facet.corners[1], facet.corners[2]},
                     .centres = {facet.centre(facet.below), facet.centre(facet.above)}};
    const double one = same_side_evidence(sides, 1);
    std::swap(sides.centres[0], sides.centres[1]);
    EXPECT_EQ(same_side_evidence(sides, 1), one) << "seed " << seed;
  }
}

TEST(SideEvidence, TellsNearlyEqualBallsApart) {
  const auto odds = [](double angle) {
    return static_cast<float>(
        same_side_evidence({.corners = {Point3{1, 0, 0}, Point3{0, 1, 0}},
                            .centres = {Point3{0.5, 0.5, 1e3}, Point3{0.5, 0.5 + angle, 1e3}}},
                           1));
  };
  EXPECT_GT(odds(0.001), odds(0.0011));
  EXPECT_TRUE(std::isfinite(odds(0)));
}

TEST(SideEvidence, SaysNothingOfBallsWithoutSize) {
  EXPECT_EQ(same_side_evidence({}, 1), 1);
  EXPECT_EQ(opposite_evidence({.cosine = std::numeric_limits<double>::quiet_NaN()}, 1), 1);
  EXPECT_EQ(opposite_evidence({.cosine = 0, .radius = 3}, 1), 1);
}

TEST(SideEvidence, OfPolesGrowsWithTheirAngleAndSize) {
  EXPECT_EQ(opposite_evidence({.cosine = 0.5, .radius = 2}, 1), 3);
  EXPECT_EQ(opposite_evidence({.cosine = 0.5, .radius = 0.5}, 1), plain_odds(0.25));
  EXPECT_GT(opposite_evidence({.cosine = 1, .radius = 2}, 1), 1e15);
}

}  // namespace
}  // namespace stream_recon
