// The spacing of a sample from its neighbours, and the lists of the nearest points.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "spatial/local_spacing.h"
#include "spatial/nearest_list.h"
#include "spatial/vector.h"
#include "tests/point_families.h"

namespace stream_recon {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

using Points = std::vector<Point3>;

/// The spacing of the sample nearest to the origin, among all points.
float spacing_at_origin(Points points) {
  const auto by_length = [](const Point3& a, const Point3& b) { return dot(a, a) < dot(b, b); };
  const Point3 sample = *std::min_element(points.begin(), points.end(), by_length);
  Points vectors;
  for (const Point3& p : points) {
    if (!(p == sample)) vectors.push_back(minus(p, sample));
  }
  std::stable_sort(vectors.begin(), vectors.end(), by_length);
  vectors.resize(std::min(vectors.size(), kSpacingNeighbors));
  return local_spacing(vectors);
}

Points turned(Points points) {
  for (Point3& p : points) {
    p = {0.36 * p.x - 0.8 * p.y + 0.48 * p.z, 0.48 * p.x + 0.6 * p.y + 0.64 * p.z,
         -0.8 * p.x + 0.6 * p.z};
  }
  return points;
}

/// Points (a i + b j, c j, 0).
Points plane_lattice(double a, double b, double c) {
  Points points;
  for (int j = -12; j <= 12; ++j) {
    for (int i = -24; i <= 24; ++i) points.push_back({a * i + b * j, c * j, 0});
  }
  return points;
}

/// Contours `gap` apart, `layers` thick.
Points contours(double gap, int layers) {
  Points points;
  for (int slice = -5; slice <= 5; ++slice) {
    for (int i = -30; i <= 30; ++i) {
      for (int layer = 0; layer < layers; ++layer) {
        points.push_back({i + (slice % 2 == 0 ? 0 : 0.4), double(layer), gap * slice});
      }
    }
  }
  return points;
}

TEST(LocalSpacing, OfEvenSamplesIsTheDistanceOfTheEighteenthNeighbor) {
  EXPECT_FLOAT_EQ(spacing_at_origin(plane_lattice(1, 0, 1)), std::sqrt(5.0F));
  EXPECT_FLOAT_EQ(spacing_at_origin(turned(plane_lattice(1, 0, 1))), std::sqrt(5.0F));
  EXPECT_FLOAT_EQ(spacing_at_origin(plane_lattice(1, 0.5, std::sqrt(0.75))), 2);
  EXPECT_FLOAT_EQ(spacing_at_origin(turned(plane_lattice(3, 1.5, 3 * std::sqrt(0.75)))), 6);
}

TEST(LocalSpacing, OfContoursReachesTheNextSlices) {
  for (const int layers : {1, 2}) {
    for (const double gap : {1.0, 2.0, 3.0, 4.0}) {
      const float spacing = spacing_at_origin(turned(contours(gap, layers)));
      EXPECT_GE(spacing, static_cast<float>(gap)) << layers << " " << gap;
      EXPECT_LE(spacing, gap + 2) << layers << " " << gap;
    }
  }
}

TEST(LocalSpacing, OfPointsOnALineIsTheDistanceOfTheNinthOnEitherSide) {
  for (const Point3& step : {Point3{1, 0, 0}, Point3{0, 0, 1}, Point3{0.1, -0.7, 0.3}}) {
    Points points;
    for (int i = -20; i <= 20; ++i) points.push_back(scaled(step, i));
    EXPECT_FLOAT_EQ(spacing_at_origin(points), static_cast<float>(9 * length(step)));
  }
}

TEST(LocalSpacing, OfAnOutlierIsHowFarItIsFromTheCloud) {
  Points points = plane_lattice(0.01, 0, 0.01);
  for (Point3& p : points) p.z = 50;
  points.push_back({0, 0, 0});
  EXPECT_NEAR(spacing_at_origin(points), 50, 0.1);
}

TEST(LocalSpacing, OfFewPointsIsFiniteAndPositive) {
  EXPECT_EQ(local_spacing({}), 1);
  EXPECT_EQ(spacing_at_origin({{0, 0, 0}, {2, 0, 0}}), 2);
  EXPECT_EQ(spacing_at_origin({{0, 0, 0}, {2, 0, 0}, {0, 0, 3}}), 3);
  for (const double size : {0x1p-200, 0x1p+100}) {
    const float spacing = spacing_at_origin({{0, 0, 0}, {size, 0, 0}, {0, size, 0}, {0, 0, size}});
    EXPECT_GT(spacing, 0);
    EXPECT_TRUE(std::isfinite(spacing));
  }
}

TEST(NearestList, KeepsTheLeastByDistanceAndRankOfAllFamilies) {
  for (const families::Family& family : families::all()) {
    SCOPED_TRACE(family.name);
    std::mt19937_64 random(7);
    constexpr std::size_t kBlocks = 40;
    std::vector<double> x, y, z;
    for (std::size_t i = 0; i < kBlocks * NearestList::kBlock; ++i) {
      const Point3 p = family.draw(random);
      x.push_back(p.x), y.push_back(p.y), z.push_back(p.z);
    }
    x[99] = y[99] = z[99] = std::numeric_limits<double>::quiet_NaN();
    const Point3 place{x[0], y[0], z[0]};
    std::vector<std::pair<double, std::uint64_t>> all;  // squared distance, rank
    for (std::size_t i = 0; i < x.size(); ++i) {
      const double dx = x[i] - place.x, dy = y[i] - place.y, dz = z[i] - place.z;
      if (i != 99) all.emplace_back(dx * dx + dy * dy + dz * dz, i);
    }
    std::sort(all.begin(), all.end());
    for (const double bound : {all[40].first, all[10].first, kInfinity}) {
      NearestList list;
      list.start(place, bound);
      for (std::size_t block = kBlocks; block-- > 0;) {
        const std::size_t first = block * NearestList::kBlock;
        list.offer({&x[first], &y[first], &z[first]}, first);
      }
      std::size_t expected = 0;
      while (expected < NearestList::kMost && all[expected].first <= bound) ++expected;
      std::array<NearPoint, NearestList::kMost> near;
      ASSERT_EQ(list.sorted(near), expected);
      EXPECT_EQ(list.is_full(), expected == NearestList::kMost);
      for (std::size_t i = 0; i < expected; ++i) {
        EXPECT_EQ(near[i].squared_distance, all[i].first);
        EXPECT_EQ(near[i].rank, all[i].second);
      }
    }
  }
}

TEST(SquaredGaps, AreAtMostTheDistancesThatAListComputes) {
  for (const families::Family& family : families::all()) {
    SCOPED_TRACE(family.name);
    if (family.name == "tiny") continue;  // such a cloud is scaled before
    std::mt19937_64 random(8);
    Points points(64);
    double reach = 0;
    for (Point3& p : points) {
      p = family.draw(random);
      reach = std::max({reach, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
    }
    const Point3 origin{0.3 * reach, 0, -0.7 * reach};
    Points relative;
    for (const Point3& p : points) relative.push_back(minus(p, origin));
    std::array<double, NearestList::kBlock> x, y, z;
    for (std::size_t i = 0; i < x.size(); ++i) {
      x[i] = relative[i].x, y[i] = relative[i].y, z[i] = relative[i].z;
    }
    for (std::size_t first = 0; first < points.size(); first += 8) {
      SquaredGaps gaps;
      squared_gaps({x.data(), y.data(), z.data()},
                   bounds_of_points({&relative[first], 8}, 2 * reach), gaps);
      for (std::size_t i = 0; i < gaps.size(); ++i) {
        for (std::size_t j = first; j < first + 8; ++j) {
          const Point3 d = minus(points[j], points[i]);
          EXPECT_LE(gaps[i], d.x * d.x + d.y * d.y + d.z * d.z);
        }
      }
    }
  }
}

}  // namespace
}  // namespace stream_recon
