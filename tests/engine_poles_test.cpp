// Poles of stars against a plain search through all tetrahedra of a cloud.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <random>
#include <vector>

#include "engine/poles/star_balls.h"
#include "engine/poles/star_poles.h"
#include "spatial/circumball.h"
#include "spatial/vector.h"

namespace stream_recon {
namespace {

/// A cloud as one window; its ranks begin anywhere.
class CloudWindow {
 public:
  explicit CloudWindow(std::vector<Point3> points) : points_(std::move(points)) {
    EXPECT_EQ(delaunay_.insert(points_), Delaunay::Outcome::kDone);
    indices_.resize(points_.size());
    std::iota(indices_.begin(), indices_.end(), 0);
  }

  FinalWindow view() const {
    return FinalWindow({.delaunay = &delaunay_,
                        .first_rank = 1000,
                        .owned_count = points_.size(),
                        .guest_ranks = {},
                        .input_indices = indices_});
  }
  const Delaunay& delaunay() const { return delaunay_; }
  const std::vector<Point3>& points() const { return points_; }

  bool is_finite(CellId c) const { return delaunay_.is_live(c) && !delaunay_.is_infinite(c); }
  Point3 centre(CellId c) const {
    const auto v = delaunay_.vertices(c);
    const Circumball ball =
        circumball({points_[v[0]], points_[v[1]], points_[v[2]], points_[v[3]]});
    return plus(ball.origin, ball.centre);
  }
  bool touches(CellId c, VertexId v) const {
    const auto corners = delaunay_.vertices(c);
    return std::find(corners.begin(), corners.end(), v) != corners.end();
  }
  bool is_on_hull(VertexId v) const {
    for (CellId c = 0; c < delaunay_.cell_slots(); ++c) {
      if (delaunay_.is_live(c) && delaunay_.is_infinite(c) && touches(c, v)) return true;
    }
    return false;
  }

 private:
  std::vector<Point3> points_;
  Delaunay delaunay_;
  std::vector<std::uint64_t> indices_;
};

std::vector<Point3> random_points(std::size_t count, std::uint64_t seed, double scale) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> one(-scale, scale);
  std::vector<Point3> points(count);
  for (Point3& p : points) p = {one(random), one(random), one(random)};
  return points;
}

TEST(StarBalls, AreTheCircumcentresFromEveryCornerAtAnyScale) {
  for (const double scale : {1.0, 0x1p-300, 0x1p300}) {
    SCOPED_TRACE(scale);
    const CloudWindow cloud(random_points(200, 1, scale));
    const FinalWindow window = cloud.view();
    const StarBalls balls(window, 1 / scale);
    std::uint32_t number = 0;
    for (CellId c = 0; c < cloud.delaunay().cell_slots(); ++c) {
      ASSERT_EQ(balls.cells().contains(c), cloud.is_finite(c));
      if (!cloud.is_finite(c)) continue;
      ASSERT_EQ(balls.cells().position(c), number);
      for (const VertexId v : cloud.delaunay().vertices(c)) {
        const Point3 expected = scaled(minus(cloud.centre(c), cloud.points()[v]), 1 / scale);
        const Point3 seen = balls.from(v, number);
        EXPECT_LE(length(minus(seen, expected)), 1e-6 * length(expected));
      }
      ++number;
    }
    EXPECT_EQ(balls.count(), number);
  }
}

TEST(StarPoles, AreTheFarthestCentresOnEitherSide) {
  const CloudWindow cloud(random_points(300, 2, 1));
  const FinalWindow window = cloud.view();
  const StarBalls balls(window, 1);
  const StarPoles poles(window, balls);
  int inner = 0;
  for (VertexId v = 0; v < cloud.points().size(); ++v) {
    if (cloud.is_on_hull(v)) {
      EXPECT_EQ(poles.pair(v).first, PolePair::kInfinity);
      continue;
    }
    ++inner;
    Point3 first;
    Point3 second;
    for (const bool is_second : {false, true}) {
      Point3& farthest = is_second ? second : first;
      for (CellId c = 0; c < cloud.delaunay().cell_slots(); ++c) {
        if (!cloud.is_finite(c) || !cloud.touches(c, v)) continue;
        const Point3 from = minus(cloud.centre(c), cloud.points()[v]);
        if (is_second && dot(from, first) >= 0) continue;
        if (length(from) > length(farthest)) farthest = from;
      }
    }
    ASSERT_TRUE(poles.pair(v).is_complete()) << v;
    const auto from_sample = [&](CellId c) { return minus(cloud.centre(c), cloud.points()[v]); };
    EXPECT_NEAR(length(from_sample(poles.pair(v).first)), length(first), 1e-6 * length(first));
    EXPECT_NEAR(length(from_sample(poles.pair(v).second)), length(second), 1e-6 * length(second));
    const PoleBalls seen = poles.balls_of(v, balls);
    EXPECT_NEAR(seen.radius, std::min(length(first), length(second)), 1e-6);
    EXPECT_NEAR(seen.cosine, -dot(first, second) / (length(first) * length(second)), 1e-6);
  }
  EXPECT_GT(inner, 100);
}

TEST(StarPoles, OfEquallyFarCentresTakeTheOneOfTheLowestRanks) {
  std::vector<Point3> lattice;
  for (int i = 0; i < 125; ++i) {
    lattice.push_back({double(i % 5), double(i / 5 % 5), double(i / 25)});
  }
  const CloudWindow cloud(lattice);
  const FinalWindow window = cloud.view();
  const StarBalls balls(window, 1);
  const StarPoles poles(window, balls);
  for (VertexId v = 0; v < lattice.size(); ++v) {
    if (cloud.is_on_hull(v)) continue;
    // The eight cubes around a lattice point have one centre each, shared by their tetrahedra.
    ASSERT_TRUE(poles.pair(v).is_complete());
    const auto from_sample = [&](CellId c) { return minus(cloud.centre(c), lattice[v]); };
    const auto corners = [&](CellId c) {
      auto sorted = cloud.delaunay().vertices(c);
      std::sort(sorted.begin(), sorted.end());
      return sorted;
    };
    CellId first = PolePair::kNone;
    CellId second = PolePair::kNone;
    for (const bool is_second : {false, true}) {
      CellId& lowest = is_second ? second : first;
      for (CellId c = 0; c < cloud.delaunay().cell_slots(); ++c) {
        if (!cloud.is_finite(c) || !cloud.touches(c, v)) continue;
        if (is_second && dot(from_sample(c), from_sample(first)) >= 0) continue;
        if (lowest == PolePair::kNone || corners(c) < corners(lowest)) lowest = c;
      }
    }
    EXPECT_EQ(poles.pair(v).first, first) << v;
    EXPECT_EQ(poles.pair(v).second, second) << v;
  }
}

}  // namespace
}  // namespace stream_recon
