// The geometry under patches: nearest points against brute force, the attraction against its
// formula worked out by hand, ring triangulations against all there are.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <random>
#include <set>
#include <string>
#include <vector>

#include "spatial/attraction.h"
#include "spatial/neighbors.h"
#include "spatial/ring_triangulation.h"
#include "spatial/vector.h"
#include "tests/point_families.h"

namespace stream_recon {
namespace {

std::vector<Point3> points_of(const families::Family& family, std::size_t count,
                              std::mt19937_64& random) {
  std::vector<Point3> points;
  for (std::size_t i = 0; i < count; ++i) points.push_back(family.draw(random));
  return points;
}

TEST(Neighbors, AreThoseOfBruteForce) {
  for (const families::Family& family : families::all()) {
    for (const std::size_t count : {0, 1, 7, 32, 33, 500}) {
      SCOPED_TRACE(family.name + ", " + std::to_string(count) + " points, seed 7");
      std::mt19937_64 random(7);
      const auto points = points_of(family, count, random);
      const Neighbors neighbors(points);
      for (int question = 0; question < 20; ++question) {
        const Point3 place =
            question % 2 == 0 || count == 0 ? family.draw(random) : points[random() % count];
        std::vector<double> distances;
        for (const Point3& p : points) {
          distances.push_back(dot(minus(p, place), minus(p, place)));
        }
        std::sort(distances.begin(), distances.end());
        const auto found = neighbors.nearest(place, 12);
        ASSERT_EQ(found.size(), std::min<std::size_t>(12, count));
        EXPECT_TRUE(std::is_sorted(found.begin(), found.end()));
        std::set<std::uint32_t> indices;
        for (std::size_t i = 0; i < found.size(); ++i) {
          indices.insert(found[i].index);
          EXPECT_EQ(found[i].squared_distance, distances[i]);
          const Point3 d = minus(points[found[i].index], place);
          EXPECT_EQ(found[i].squared_distance, dot(d, d));
        }
        EXPECT_EQ(indices.size(), found.size());
      }
    }
  }
}

TEST(Neighbors, ManyPointsAtOnePlace) {
  const std::vector<Point3> points(1000, Point3{1, 2, 3});
  EXPECT_EQ(Neighbors(points).nearest({1, 2, 3}, 5).size(), 5U);
}

TEST(Attraction, FollowsTheFormula) {
  // From (0, 0, 0): distances 1 and 2, powers 1 and 2^-16; a = 0.5, n = 2.
  const std::vector<Point3> ring{{1, 0, 0}, {0, 2, 0}};
  const Point3 p = attracted_once({0, 0, 0}, ring, {});
  EXPECT_EQ(p, (Point3{0.25, 0.25 * 2 / 65536, 0}));
}

TEST(Attraction, CountsDifferencesInUnits) {
  // Distances 10 and 20, a difference of 1 unit, as above.
  const std::vector<Point3> ring{{10, 0, 0}, {0, 20, 0}};
  AttractionOptions options;
  options.unit = 10;
  options.rate = 1;
  const Point3 p = attracted_once({0, 0, 0}, ring, options);
  EXPECT_EQ(p, (Point3{5, 10.0 / 65536, 0}));
}

TEST(Attraction, EquallyFarPointsDrawBetweenThem) {
  const std::vector<Point3> ring{{1, 1, 0}, {-1, 1, 0}};
  const Attracted end = attracted({0, 0, 0}, ring, {.most_steps = 100, .still = 1e-6});
  EXPECT_TRUE(end.is_still);
  EXPECT_EQ(end.place.x, 0);
  EXPECT_NEAR(end.place.y, 1, 1e-5);
}

TEST(Attraction, StopsAtItsStepsAndWhenStill) {
  const std::vector<Point3> ring{{1, 0, 0}};
  const Attracted two = attracted({0, 0, 0}, ring, {.most_steps = 2, .still = 0});
  EXPECT_EQ(two.place.x, 0.75);
  EXPECT_FALSE(two.is_still);
  EXPECT_TRUE(attracted({0, 0, 0}, ring, {.still = 0.6}).is_still);
  EXPECT_EQ(attracted({3, 0, 0}, {}, {}).place, (Point3{3, 0, 0}));
}

double area(const std::vector<Point3>& ring, const std::vector<std::array<std::uint32_t, 3>>& all) {
  double sum = 0;
  for (const auto& [a, b, c] : all) {
    sum += length(cross(minus(ring[b], ring[a]), minus(ring[c], ring[a])));
  }
  return sum;
}

/// Of all triangulations of the places from..to: edge by edge, without remembering anything.
double least_area(const std::vector<Point3>& ring, std::uint32_t from, std::uint32_t to) {
  if (to - from < 2) return 0;
  double best = std::numeric_limits<double>::infinity();
  for (std::uint32_t apex = from + 1; apex < to; ++apex) {
    best = std::min(best, least_area(ring, from, apex) + least_area(ring, apex, to) +
                              area(ring, {{from, apex, to}}));
  }
  return best;
}

TEST(RingTriangulation, HasTheLeastAreaOfAll) {
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937_64 random(seed);
    std::vector<Point3> ring;
    while (ring.size() < 3 + seed % 6) ring.push_back(families::random_point(random));
    const auto triangles = ring_triangulation(ring);
    const auto n = static_cast<std::uint32_t>(ring.size());
    ASSERT_EQ(triangles.size(), n - 2);
    EXPECT_NEAR(area(ring, triangles), least_area(ring, 0, n - 1), 1e-12);
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> directed;
    for (const auto& t : triangles) {
      for (std::size_t i = 0; i < 3; ++i) ++directed[{t[i], t[(i + 1) % 3]}];
    }
    for (const auto& [edge, count] : directed) {
      EXPECT_EQ(count, 1);
      const bool is_ring = edge.second == (edge.first + 1) % n;
      EXPECT_NE(is_ring, directed.contains({edge.second, edge.first}));
    }
  }
}

TEST(RingTriangulation, PrefersWelcomeEdges) {
  // A long lozenge: the short diagonal has the same area as the long one.
  const std::vector<Point3> ring{{-3, 0, 0}, {0, -1, 0}, {3, 0, 0}, {0, 1, 0}};
  const auto has_edge = [&](std::uint32_t a, std::uint32_t b) {
    const auto triangles =
        ring_triangulation(ring, [&](auto from, auto to) { return from == a && to == b; });
    return std::all_of(triangles.begin(), triangles.end(), [&](const auto& t) {
      return std::count(t.begin(), t.end(), a) == 1 && std::count(t.begin(), t.end(), b) == 1;
    });
  };
  EXPECT_TRUE(has_edge(0, 2));
  EXPECT_TRUE(has_edge(1, 3));
}

}  // namespace
}  // namespace stream_recon
