// Walks through a window of samples: the answers are those of may_conflict(), whichever ball is
// kept, and everything in conflict is found from any tetrahedron that is.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <set>
#include <vector>

#include "engine/power/ball_walk.h"
#include "engine/windows/certified_window.h"
#include "engine/windows/index_reader.h"
#include "spatial/circumball.h"
#include "spatial/orthosphere.h"
#include "spatial/vector.h"
#include "tests/exact_reference.h"
#include "tests/point_families.h"
#include "tests/pole_clouds.h"

namespace stream_recon {
namespace {

constexpr std::uint64_t kMemory = std::uint64_t{1} << 30;
constexpr int kSpheres = 150;

using Corners = std::array<Point3, 4>;

std::vector<Point3> lattice(int side) {
  std::vector<Point3> points;
  points.reserve(static_cast<std::size_t>(side) * side * side);
  for (int z = 0; z < side; ++z) {
    for (int y = 0; y < side; ++y) {
      for (int x = 0; x < side; ++x) points.push_back({1.0 * x, 1.0 * y, 1.0 * z});
    }
  }
  return points;
}

/// On a thin bent sheet: many large balls, and slivers.
std::vector<Point3> sheet(std::size_t count) {
  std::mt19937_64 random(3);
  std::vector<Point3> points;
  while (points.size() < count) {
    const Point3 p = families::random_point(random);
    points.push_back({p.x, p.y, 0.02 * p.x * p.x + 1e-7 * p.z});
  }
  return points;
}

struct OneWindow {
  explicit OneWindow(const std::vector<Point3>& points)
      : cloud(points, [](const Point3&) { return true; }),
        caches(cloud.stage.scratch, cloud.index, std::uint64_t{16} << 20),
        reader(caches),
        samples(cloud.index, reader, cloud.stage.context, {.whole_stars = true}) {
    const OwnedRange all{0, cloud.index.point_count};
    EXPECT_EQ(samples.build(all, kMemory), CertifiedWindow::Outcome::kDone);
    const CellView view = cells();
    for (CellId c = 0; c < view.slots(); ++c) {
      if (view.is_live(c) && !view.is_infinite(c)) bounded.push_back(c);
    }
  }

  CellView cells() const { return samples.view().delaunay().view(); }
  Corners corners(CellId c) const { return cells().corners(c); }

  PoleCloud cloud;
  IndexCaches caches;
  IndexReader reader;
  CertifiedWindow samples;
  std::vector<CellId> bounded;
};

/// Spheres with ties among them: around samples, and orthogonal to balls.
std::vector<Orthosphere> spheres(const OneWindow& window) {
  std::mt19937_64 random(8);
  std::vector<Orthosphere> made;
  for (int i = 0; i < kSpheres; ++i) {
    const Corners near = window.corners(window.bounded[random() % window.bounded.size()]);
    const Point3 mean = scaled(plus(plus(near[0], near[1]), plus(near[2], near[3])), 0.25);
    const Point3 d = minus(mean, near[0]);
    const double square = dot(d, d);
    made.push_back({near[0], 0, i % 2 == 0 ? 0 : 1e-3 * square});
    made.push_back({mean, -square * static_cast<double>(random() % 100) / 100, 0});
    const Circumball ball = circumball(near);
    const Point3 q = minus(mean, ball.origin);
    made.push_back({mean, dot(q, q) - 2 * dot(q, ball.centre), 0});
  }
  return made;
}

bool is_in_conflict(const Corners& t, const Orthosphere& sphere) {
  const int turn = reference::orient3d(t[0], t[1], t[2], t[3]);
  const int side = reference::power_test({{{t[0], 0},
                                           {t[1], 0},
                                           {t[2], 0},
                                           {t[3], 0},
                                           {sphere.centre, sphere.weight + sphere.error}}});
  return turn * side > 0;
}

class Walks : public testing::TestWithParam<std::vector<Point3> (*)()> {};

TEST_P(Walks, MissNoConflictAndSeeNoneWhereMayConflictSeesNone) {
  const OneWindow window(GetParam()());
  BallWalk walk(window.samples);
  std::mt19937_64 random(4);
  int conflicts = 0;
  int frees = 0;
  for (const Orthosphere& sphere : spheres(window)) {
    walk.begin();
    walk.aim(sphere);
    for (int i = 0; i < 60; ++i) {
      const CellId cell = window.bounded[random() % window.bounded.size()];
      ASSERT_EQ(walk.kind(cell), BallWalk::Kind::kBounded);
      const Corners corners = window.corners(cell);
      const bool says = walk.in_conflict(cell);
      EXPECT_TRUE(says || !is_in_conflict(corners, sphere));
      EXPECT_TRUE(!says || may_conflict(corners, sphere));
      EXPECT_EQ(walk.in_conflict(cell), says) << "asked again";
      ++(says ? conflicts : frees);
    }
  }
  EXPECT_GT(conflicts, 50);
  EXPECT_GT(frees, 50);
}

TEST_P(Walks, ComeByEverythingInConflict) {
  const OneWindow window(GetParam()());
  BallWalk walk(window.samples);
  int walks = 0;
  for (const Orthosphere& sphere : spheres(window)) {
    std::set<CellId> expected;
    for (const CellId cell : window.bounded) {
      const Corners corners = window.corners(cell);  // may_conflict() misses none
      if (may_conflict(corners, sphere) && is_in_conflict(corners, sphere)) expected.insert(cell);
    }
    if (expected.empty()) continue;
    if (++walks > 30) break;
    walk.begin();
    walk.aim(sphere);
    std::set<CellId> found;
    const CellId start = *expected.begin();
    walk.visit(start);
    EXPECT_FALSE(walk.visit(start));
    walk.add(start);
    found.insert(start);
    for (;;) {
      const std::vector<CellId>& neighbors = walk.step();
      if (neighbors.empty()) break;
      for (const CellId next : neighbors) {
        if (!walk.visit(next) || walk.kind(next) != BallWalk::Kind::kBounded) continue;
        if (!walk.in_conflict(next)) continue;
        walk.add(next);
        found.insert(next);
      }
    }
    EXPECT_TRUE(std::includes(found.begin(), found.end(), expected.begin(), expected.end()))
        << found.size() << " of " << expected.size();
  }
  EXPECT_GT(walks, 20);
}

INSTANTIATE_TEST_SUITE_P(Clouds, Walks,
                         testing::Values([] { return sheet(700); }, [] { return lattice(8); }),
                         [](const auto& test) {
                           return test.index == 0 ? std::string("sheet") : std::string("lattice");
                         });

}  // namespace
}  // namespace stream_recon
