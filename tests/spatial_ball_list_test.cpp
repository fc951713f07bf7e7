// Many balls and half-spaces against a node: none that holds a point is dropped, and few others are
// kept.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
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

/// A frame for points of which the node's are a part.
ListFrame frame_around(const std::vector<Point3>& points, double factor, std::mt19937_64& random) {
  std::vector<Point3> more = points;
  const NodeBounds bounds = bounds_of_points(points, reach_of(points));
  const double by = (factor - 1) * std::sqrt(squared_diagonal(bounds));
  more.push_back(moved(points[0], unit(random), by));
  return ListFrame(bounds_of_points(more, reach_of(more)));
}

class Regions : public testing::Test {
 protected:
  std::unique_ptr<BallList> in_ = std::make_unique<BallList>();
  std::unique_ptr<BallList> out_ = std::make_unique<BallList>();
};

TEST_F(Regions, TouchingKeepsEveryBallThatHoldsAPoint) {
  for (const double size : {1.0, 1e-30, 1e6, 1e30}) {
    for (unsigned seed = 0; seed < kSeeds; ++seed) {
      SCOPED_TRACE("size " + std::to_string(std::log10(size)) + ", seed " + std::to_string(seed));
      std::mt19937_64 random(seed);
      const std::vector<Point3> points = patch(seed % 4 * 0.1, size, random);
      const double reach = reach_of(points);
      const ListFrame frame = frame_around(points, seed % 3 == 0 ? 1 : 30, random);
      std::vector<Ball> balls;
      in_->count = 0;
      for (std::uint32_t i = 0; i < BallList::kMost; ++i) {
        balls.push_back(draw_ball(points, size, random));
        in_->push(ball_in(frame, balls[i].centre, squared_up(balls[i].radius, reach)), i);
      }
      touching(*in_, bounds_of_points(points, reach), frame, *out_);
      const std::set<std::uint32_t> kept = ids(*out_);
      for (std::uint32_t i = 0; i < BallList::kMost; ++i) {
        ASSERT_TRUE(holds_any(balls[i], points)) << "the test's own ball " << i;
        EXPECT_TRUE(kept.contains(i)) << "ball " << i << " of radius " << balls[i].radius;
      }
    }
  }
}

TEST_F(Regions, TouchingKeepsEveryHalfSpaceThatHoldsAPointAndFewOthers) {
  for (unsigned seed = 0; seed < kSeeds; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937_64 random(seed);
    const std::vector<Point3> points = patch(seed % 4 * 0.1, 1, random);
    const ListFrame frame = frame_around(points, seed % 3 == 0 ? 1 : 30, random);
    for (const bool is_beyond : {false, true}) {
      in_->count = 0;
      for (std::uint32_t i = 0; i < BallList::kMost; ++i) {
        const Point3 normal = unit(random);
        double highest = -1e300;
        for (const Point3& p : points) {
          highest = std::max(highest, normal.x * p.x + normal.y * p.y + normal.z * p.z);
        }
        in_->push(half_space_in(frame, normal, highest + (is_beyond ? 1 : -1e-15)), i);
      }
      touching(*in_, bounds_of_points(points, reach_of(points)), frame, *out_);
      if (is_beyond) {
        EXPECT_LT(out_->count, BallList::kMost / 10);
      } else {
        EXPECT_EQ(out_->count, BallList::kMost);
      }
    }
  }
}

#if defined(__x86_64__)
TEST_F(Regions, TouchingIsTheSameOnEveryProcessor) {
  if (!__builtin_cpu_supports("avx2")) GTEST_SKIP() << "no second variant here";
  const auto expected = std::make_unique<BallList>();
  for (unsigned seed = 0; seed < kSeeds; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937_64 random(seed);
    const std::vector<Point3> points = patch(seed % 4 * 0.1, 1, random);
    const NodeBounds node = bounds_of_points({points.data(), 16}, reach_of(points));
    const ListFrame frame(bounds_of_points(points, reach_of(points)));
    in_->count = 0;
    for (std::uint32_t i = 0; i < BallList::kMost - seed; ++i) {
      const Ball ball = draw_ball(points, 1, random);
      const double squared = ball.radius * ball.radius * (i % 2 ? 1 : 0.9);
      in_->push(ball_in(frame, ball.centre, squared), i);
    }
    detail::touching_portable(*in_, node, frame, *expected);
    detail::touching_avx2(*in_, node, frame, *out_);
    EXPECT_EQ(ids(*out_), ids(*expected));
    EXPECT_LT(out_->count, in_->count);
  }
}
#endif

TEST_F(Regions, TouchingKeepsARegionOfWhichNothingIsKnown) {
  std::mt19937_64 random(1);
  const std::vector<Point3> points = patch(0.1, 1, random);
  const NodeBounds node = bounds_of_points(points, reach_of(points));
  const ListFrame frame(node);
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  constexpr double kNothing = std::numeric_limits<double>::quiet_NaN();
  in_->count = 0;
  in_->push(ball_in(frame, {}, kInfinity), 0);
  in_->push(ball_in(frame, {kInfinity, 0, 0}, kInfinity), 1);
  in_->push(ball_in(frame, {1e200, 0, 0}, kInfinity), 2);
  in_->push(half_space_in(frame, {kNothing, kNothing, kNothing}, kNothing), 3);
  in_->push(half_space_in(frame, {1, 0, 0}, -kInfinity), 4);
  touching(*in_, node, frame, *out_);
  EXPECT_EQ(out_->count, 5u);
}

TEST_F(Regions, TouchingDropsBallsThatEndBeforeTheNode) {
  for (unsigned seed = 0; seed < kSeeds; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> exponent(-4, 9);
    const std::vector<Point3> points = patch(0.1, 1, random);
    const NodeBounds node = bounds_of_points(points, 4);
    const ListFrame frame(node);
    in_->count = 0;
    for (std::uint32_t i = 0; i < BallList::kMost; ++i) {
      const double radius = std::pow(10.0, exponent(random));
      const Point3 centre = moved({2, -1, 0}, unit(random), radius + 4);
      in_->push(ball_in(frame, centre, squared_up(radius, 4)), i);
    }
    touching(*in_, node, frame, *out_);
    EXPECT_LT(out_->count, BallList::kMost / 50);
  }
}

TEST_F(Regions, TouchingDropsHugeBallsThatReachTheBoxBesideThePatch) {
  for (unsigned seed = 0; seed < kSeeds; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937_64 random(seed);
    const double bend = seed % 3 * 0.05;
    const std::vector<Point3> points = patch(bend, 1, random);
    const NodeBounds node = bounds_of_points(points, 4);
    const ListFrame frame = frame_around(points, seed % 2 == 0 ? 1 : 30, random);
    in_->count = 0;
    // Below the patch, which is bent upward and deep in the box: tangent to its plane in the middle
    // but for a gap of a hundredth.
    const double length = std::sqrt(0.36 + 0.09 + 1);
    for (std::uint32_t i = 0; i < 64; ++i) {
      const double radius = std::ldexp(100, static_cast<int>(i / 4));
      const Point3 normal{-0.6 / length, 0.3 / length, 1 / length};
      in_->push(ball_in(frame, moved({2, -1, 0}, normal, -radius - 0.01), squared_up(radius, 4)),
                i);
    }
    touching(*in_, node, frame, *out_);
    EXPECT_EQ(out_->count, 0u);
  }
}

TEST_F(Regions, TouchingKeepsOrderAndValuesForEveryCount) {
  const std::vector<Point3> points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  const NodeBounds node = bounds_of_points(points, 1);
  const ListFrame frame(node);
  for (const std::size_t count : {0, 1, 2, 7, 8, 9, 63, 64, 65, 127, 511, 512}) {
    for (unsigned seed = 0; seed < 8; ++seed) {
      SCOPED_TRACE("count " + std::to_string(count) + ", seed " + std::to_string(seed));
      std::mt19937_64 random(seed);
      in_->count = 0;
      std::vector<std::uint32_t> near;
      for (std::uint32_t i = 0; i < BallList::kMost; ++i) {
        // Of the first `count` some, by seed all or none; all behind, which must not come in.
        const bool is_near = i >= count || seed == 0 || (seed > 1 && random() % seed == 0);
        const double x = is_near ? 1e-3 * i : 100 + i;
        const std::uint32_t id = 7 * i + 1;
        if (is_near && i < count) near.push_back(id);
        in_->push(ball_in(frame, {x, 0, 0}, 1 + 1e-3 * i), id);
      }
      in_->count = count;
      out_->count = 17;
      touching(*in_, node, frame, *out_);
      ASSERT_EQ(out_->count, near.size());
      for (std::size_t i = 0; i < near.size(); ++i) {
        const std::uint32_t from = (near[i] - 1) / 7;
        ASSERT_EQ(out_->id[i], near[i]);
        ASSERT_EQ(out_->x[i], in_->x[from]);
        ASSERT_EQ(out_->y[i], in_->y[from]);
        ASSERT_EQ(out_->z[i], in_->z[from]);
        ASSERT_EQ(out_->lift[i], in_->lift[from]);
        ASSERT_EQ(out_->power[i], in_->power[from]);
      }
    }
  }
}

}  // namespace
}  // namespace stream_recon
