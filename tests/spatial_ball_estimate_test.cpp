// What criteria judge on estimated balls, against the accurate balls; the variants of the estimator
// against each other.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "spatial/alpha_facet.h"
#include "spatial/cell_balls.h"
#include "spatial/facet_balls.h"
#include "spatial/gamma_facet.h"
#include "tests/point_families.h"

namespace stream_recon {
namespace {

/// A facet of a Delaunay structure with what is estimated and what is accurate.
struct JudgedFacet {
  BallEstimate near, far;
  FacetBalls balls;
};

std::vector<Point3> distinct(std::vector<Point3> points) {
  std::sort(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end()), points.end());
  return points;
}

std::vector<JudgedFacet> facets_of(const std::vector<Point3>& points) {
  std::vector<JudgedFacet> result;
  Delaunay delaunay;
  if (delaunay.insert(points) != Delaunay::Outcome::kDone) return result;
  const CellView cells = delaunay.view();
  std::vector<CellId> finite;
  for (CellId c = 0; c < cells.slots(); ++c) {
    if (cells.is_live(c) && !cells.is_infinite(c)) finite.push_back(c);
  }
  std::vector<CellBall> estimates(finite.size());
  BallEstimator(cells).estimate(finite, estimates);
  std::vector<CellBall> balls(cells.slots());
  for (std::size_t i = 0; i < finite.size(); ++i) balls[finite[i]] = estimates[i];
  for (const CellId cell : finite) {
    for (int side = 0; side < 4; ++side) {
      const CellId beyond = cells.neighbor(cell, side);
      const int mirror = cells.mirror_index(cell, side);
      auto v = cells.facet(cell, side);
      std::sort(v.begin(), v.end());
      const std::array<Point3, 3> corners{cells.point(v[0]), cells.point(v[1]), cells.point(v[2])};
      const Point3 apex = cells.point(cells.vertex(cell, side));
      const BallEstimate near = balls[cell].from(side);
      if (cells.is_infinite(beyond)) {
        result.push_back({near, BallEstimate{}, hull_facet_balls(corners, apex)});
      } else {
        result.push_back({near, balls[beyond].from(mirror),
                          facet_balls(corners, apex, cells.point(cells.vertex(beyond, mirror)))});
      }
    }
  }
  return result;
}

/// Clouds of 40 points of a family; every third is squeezed, so that slivers are made.
std::vector<JudgedFacet> draw_facets(const families::Family& family, std::mt19937_64& random) {
  std::vector<JudgedFacet> result;
  for (int cloud = 0; cloud < 12; ++cloud) {
    const double squeeze = cloud % 3 == 2 ? std::ldexp(1.0, -4 * cloud) : 1;
    std::vector<Point3> points;
    for (int i = 0; i < 40; ++i) {
      const Point3 p = family.draw(random);
      points.push_back({p.x, p.y, p.z * squeeze + (squeeze < 1 ? p.x : 0)});
    }
    const auto facets = facets_of(distinct(points));
    result.insert(result.end(), facets.begin(), facets.end());
  }
  return result;
}

/// Counts the sure ones.
template <class Criterion>
int check_judgements(const std::vector<JudgedFacet>& facets, const Criterion& criterion,
                     const std::string& where) {
  int sure = 0;
  for (const JudgedFacet& facet : facets) {
    const bool taken = criterion.takes(facet.balls);
    const Verdict verdict = criterion.judge(facet.near, facet.far);
    EXPECT_EQ(criterion.judge(facet.far, facet.near), verdict) << where;
    if (verdict != Verdict::kUnsure) {
      EXPECT_EQ(verdict == Verdict::kIn, taken) << where;
      ++sure;
    }
    for (const BallEstimate& ball : {facet.near, facet.far}) {
      if (criterion.judge(ball, BallEstimate{}) == Verdict::kOut) {
        EXPECT_FALSE(taken) << where << ", from one side";
      }
    }
  }
  return sure;
}

std::vector<families::Family> families_and_huge() {
  std::vector<families::Family> result = families::all();
  result.push_back(
      {"huge", [](std::mt19937_64& r) { return families::lattice_point(r, 9, 1e36); }});
  result.push_back(
      {"beyond scaling", [](std::mt19937_64& r) { return families::lattice_point(r, 9, 1e120); }});
  result.push_back(
      {"denormal", [](std::mt19937_64& r) { return families::lattice_point(r, 9, 0x1p-1070); }});
  return result;
}

TEST(BallEstimate, GammaIsNeverJudgedAgainstTheAccurateBalls) {
  constexpr int kSeed = 5;
  for (const families::Family& family : families_and_huge()) {
    std::mt19937_64 random(kSeed);
    const auto facets = draw_facets(family, random);
    for (const double delta_max : {1e-3, 30.0, 60.0, 90.0, 120.0, 179.0, 180.0}) {
      const std::string where =
          family.name + ", delta-max " + std::to_string(delta_max) + ", seed 5";
      check_judgements(facets, GammaCriterion(delta_max), where);
    }
  }
}

TEST(BallEstimate, GammaIsJudgedByTheRuleWhereAnglesTieWithTheThreshold) {
  constexpr int kSeed = 6;
  for (const families::Family& family : families_and_huge()) {
    std::mt19937_64 random(kSeed);
    const auto facets = draw_facets(family, random);
    for (std::size_t i = 0; i < facets.size(); i += 7) {
      const double angle = gamma_angle(facets[i].balls);
      if (!(angle > 0 && angle <= 180)) continue;
      check_judgements({facets[i]}, GammaCriterion(angle), family.name + ", seed 6");
    }
  }
}

TEST(BallEstimate, AlphaIsNeverJudgedAgainstTheAccurateBalls) {
  constexpr int kSeed = 7;
  for (const families::Family& family : families_and_huge()) {
    std::mt19937_64 random(kSeed);
    const auto facets = draw_facets(family, random);
    for (std::size_t i = 0; i < facets.size(); i += 97) {
      const RadiusInterval radii = empty_ball_radii(facets[i].balls);
      for (const double alpha : {radii.smallest, 1.5 * radii.smallest, radii.largest}) {
        if (!std::isfinite(alpha) || alpha <= 0) continue;
        const std::string where = family.name + ", alpha " + std::to_string(alpha) + ", seed 7";
        check_judgements(facets, AlphaCriterion(alpha), where);
      }
    }
  }
}

TEST(BallEstimate, AlmostAllFacetsOfRandomPointsAreSure) {
  std::mt19937_64 random(8);
  std::vector<Point3> points;
  for (int i = 0; i < 2000; ++i) points.push_back(families::random_point(random));
  const auto facets = facets_of(distinct(points));
  const int least = static_cast<int>(facets.size()) * 99 / 100;
  EXPECT_GT(check_judgements(facets, GammaCriterion(90), "seed 8"), least);
  EXPECT_GT(check_judgements(facets, AlphaCriterion(0.1), "seed 8"), least);
}

TEST(BallEstimate, HeightsAndRadiiKeepTheirPromise) {
  constexpr int kSeed = 9;
  for (const families::Family& family : families_and_huge()) {
    std::mt19937_64 random(kSeed);
    for (const JudgedFacet& facet : draw_facets(family, random)) {
      const double height = facet.balls.height[0] / facet.balls.radius;
      const double size = std::hypot(1.0, height);
      if (!std::isnan(facet.near.height)) {
        EXPECT_LE(std::abs(facet.near.height - height), BallEstimate::kError * size)
            << family.name << ", seed 9";
      }
      const double radius = std::hypot(facet.balls.radius, facet.balls.height[0]);
      if (!std::isnan(facet.near.radius)) {
        EXPECT_LE(std::abs(facet.near.radius - radius), BallEstimate::kError * radius)
            << family.name << ", seed 9";
      }
    }
  }
}

TEST(BallEstimate, HasTheSameBitsOnEveryProcessor) {
#if defined(__x86_64__)
  if (!__builtin_cpu_supports("avx2")) GTEST_SKIP() << "no AVX2 here";
  std::mt19937_64 random(10);
  for (const families::Family& family : families_and_huge()) {
    detail::BallLanes one{};
    for (std::size_t lane = 0; lane < detail::BallLanes::kCount; ++lane) {
      for (int i = 0; i < 4; ++i) {
        const Point3 p = family.draw(random);
        one.x[i][lane] = p.x;
        one.y[i][lane] = p.y;
        one.z[i][lane] = p.z;
      }
    }
    detail::BallLanes two = one;
    detail::estimate_lanes_portable(one);
    detail::estimate_lanes_avx2(two);
    const auto same = [](double a, double b) { return a == b || (std::isnan(a) && std::isnan(b)); };
    for (std::size_t lane = 0; lane < detail::BallLanes::kCount; ++lane) {
      for (int i = 0; i < 4; ++i) {
        EXPECT_TRUE(same(one.height[i][lane], two.height[i][lane])) << family.name << ", seed 10";
      }
      EXPECT_TRUE(same(one.radius[lane], two.radius[lane])) << family.name << ", seed 10";
    }
  }
#endif
}

}  // namespace
}  // namespace stream_recon
