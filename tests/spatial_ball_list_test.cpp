// Many balls against a node: none that holds a point is dropped, and few others are kept.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <random>
#include <set>
#include <string>
#include <vector>

#include "spatial/ball_list.h"
#include "spatial/node_bounds.h"
#include "tests/point_families.h"

namespace stream_recon {
namespace {

using Long = long double;

constexpr unsigned kSeeds = 40;

struct Ball {
  Point3 centre;
  double radius;
};

Long distance(const Point3& a, const Point3& b) {
  const Long x = Long{a.x} - b.x;
  const Long y = Long{a.y} - b.y;
  const Long z = Long{a.z} - b.z;
  return std::sqrt(x * x + y * y + z * z);
}

Point3 moved(const Point3& p, const Point3& direction, double by) {
  return {p.x + by * direction.x, p.y + by * direction.y, p.z + by * direction.z};
}

Point3 unit(std::mt19937_64& random) {
  std::normal_distribution<double> normal;
  const Point3 p{normal(random), normal(random), normal(random)};
  return moved({}, p, 1 / std::hypot(p.x, p.y, p.z));
}

/// A patch of a graph over a tilted plane; `bend` 0 is plane.
std::vector<Point3> patch(double bend, double size, std::mt19937_64& random) {
  std::vector<Point3> points;
  for (int i = 0; i < 64; ++i) {
    const Point3 p = families::random_point(random);
    const double z = 0.6 * p.x - 0.3 * p.y + bend * (p.x * p.x + p.y * p.y);
    points.push_back({size * (p.x + 2), size * (p.y - 1), size * z});
  }
  return points;
}

double reach_of(const std::vector<Point3>& points) {
  double reach = 0;
  for (const Point3& p : points) {
    reach = std::max({reach, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
  }
  return reach;
}

/// What is uncertain: the distances that touching() computes, to some roundings of the coordinates.
double squared_up(double radius, double reach) {
  const double most = (radius + 2e-14 * (radius + 4 * reach)) * (1 + 1e-14);
  return most * most;
}

bool holds_any(const Ball& ball, const std::vector<Point3>& points) {
  return std::any_of(points.begin(), points.end(), [&ball](const Point3& p) {
    return distance(p, ball.centre) <= Long{ball.radius};
  });
}

/// Balls through a point, inside or outside of the patch, at most as far away as 1e9 of its sizes:
/// half of them in the direction of the patch's plane or normal.
Ball draw_ball(const std::vector<Point3>& points, double size, std::mt19937_64& random) {
  std::uniform_real_distribution<double> exponent(-4, 9);
  const Point3& p = points[random() % points.size()];
  const double radius = size * std::pow(10.0, exponent(random));
  const double length = std::sqrt(0.36 + 0.09 + 1);
  const Point3 normal{-0.6 / length, 0.3 / length, 1 / length};
  Point3 direction = unit(random);
  if (random() % 2) direction = moved({}, normal, random() % 2 ? 1 : -1);
  const Point3 centre = moved(p, direction, radius);
  return {centre, std::nextafter(static_cast<double>(distance(p, centre)), 1e300)};
}

std::set<std::uint32_t> ids(const BallList& list) {
  return {list.id.begin(), list.id.begin() + static_cast<std::ptrdiff_t>(list.count)};
}

TEST(BallList, TouchingKeepsEveryBallThatHoldsAPoint) {
  const auto in = std::make_unique<BallList>();
  const auto out = std::make_unique<BallList>();
  for (const double size : {1.0, 1e-30, 1e6}) {
    for (unsigned seed = 0; seed < kSeeds; ++seed) {
      SCOPED_TRACE("size " + std::to_string(std::log10(size)) + ", seed " + std::to_string(seed));
      std::mt19937_64 random(seed);
      const std::vector<Point3> points = patch(seed % 4 * 0.1, size, random);
      const double reach = reach_of(points);
      std::vector<Ball> balls;
      in->count = 0;
      for (std::uint32_t i = 0; i < BallList::kMost; ++i) {
        balls.push_back(draw_ball(points, size, random));
        in->push(balls[i].centre, squared_up(balls[i].radius, reach), i);
      }
      touching(*in, NodeFrame(bounds_of_points(points, reach)), *out);
      const std::set<std::uint32_t> kept = ids(*out);
      for (std::uint32_t i = 0; i < BallList::kMost; ++i) {
        ASSERT_TRUE(holds_any(balls[i], points)) << "the test's own ball " << i;
        EXPECT_TRUE(kept.contains(i)) << "ball " << i << " of radius " << balls[i].radius;
      }
    }
  }
}

TEST(BallList, TouchingDropsBallsThatEndBeforeTheNode) {
  const auto in = std::make_unique<BallList>();
  const auto out = std::make_unique<BallList>();
  for (unsigned seed = 0; seed < kSeeds; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> exponent(-4, 9);
    const std::vector<Point3> points = patch(0.1, 1, random);
    in->count = 0;
    for (std::uint32_t i = 0; i < BallList::kMost; ++i) {
      const double radius = std::pow(10.0, exponent(random));
      const Point3 centre = moved({2, -1, 0}, unit(random), radius + 4);
      in->push(centre, squared_up(radius, 4), i);
    }
    touching(*in, NodeFrame(bounds_of_points(points, 4)), *out);
    EXPECT_LT(out->count, BallList::kMost / 50);
  }
}

TEST(BallList, TouchingDropsHugeBallsThatReachTheBoxBesideTheDisc) {
  const auto in = std::make_unique<BallList>();
  const auto out = std::make_unique<BallList>();
  for (unsigned seed = 0; seed < kSeeds; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937_64 random(seed);
    const std::vector<Point3> points = patch(0, 1, random);
    const NodeFrame node(bounds_of_points(points, 4));
    in->count = 0;
    // Tangent to the plane of the patch but for a gap of a hundredth, deep in the box.
    const double length = std::sqrt(0.36 + 0.09 + 1);
    for (std::uint32_t i = 0; i < 64; ++i) {
      const double radius = std::ldexp(100, static_cast<int>(i / 4));
      const double by = (i % 2 ? 1 : -1) * (radius + 0.01);
      const Point3 normal{-0.6 / length, 0.3 / length, 1 / length};
      in->push(moved({2, -1, 0}, normal, by), squared_up(radius, 4), i);
    }
    touching(*in, node, *out);
    EXPECT_EQ(out->count, 0u);
  }
}

TEST(BallList, TouchingKeepsOrderAndValuesForEveryCount) {
  const auto in = std::make_unique<BallList>();
  const auto out = std::make_unique<BallList>();
  const std::vector<Point3> points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  const NodeFrame node(bounds_of_points(points, 1));
  for (const std::size_t count : {0, 1, 2, 3, 4, 5, 63, 64, 65, 127, 511, 512}) {
    for (unsigned seed = 0; seed < 8; ++seed) {
      SCOPED_TRACE("count " + std::to_string(count) + ", seed " + std::to_string(seed));
      std::mt19937_64 random(seed);
      in->count = 0;
      std::vector<std::uint32_t> near;
      for (std::uint32_t i = 0; i < BallList::kMost; ++i) {
        // Of the first `count` some, by seed all or none; all behind, which must not come in.
        const bool is_near = i >= count || seed == 0 || (seed > 1 && random() % seed == 0);
        const double x = is_near ? 1e-3 * i : 100 + i;
        const std::uint32_t id = 7 * i + 1;
        if (is_near && i < count) near.push_back(id);
        in->push({x, 0, 0}, 1 + 1e-3 * i, id);
      }
      in->count = count;
      out->count = 17;
      touching(*in, node, *out);
      ASSERT_EQ(out->count, near.size());
      for (std::size_t i = 0; i < near.size(); ++i) {
        const std::uint32_t from = (near[i] - 1) / 7;
        ASSERT_EQ(out->id[i], near[i]);
        ASSERT_EQ(out->x[i], in->x[from]);
        ASSERT_EQ(out->y[i], in->y[from]);
        ASSERT_EQ(out->z[i], in->z[from]);
        ASSERT_EQ(out->squared[i], in->squared[from]);
      }
    }
  }
}

}  // namespace
}  // namespace stream_recon
