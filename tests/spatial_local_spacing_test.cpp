// The spacing of a sample from its neighbours, and what it is made of: nearest points, gaps between
// directions.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "spatial/direction_gaps.h"
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

/// Contours `gap` apart, `layers` thick, those for which keep() is true.
template <class Keep>
Points contours(double gap, int layers, const Keep& keep) {
  Points points;
  for (int slice = -5; slice <= 5; ++slice) {
    for (int i = -30; i <= 30; ++i) {
      for (int layer = 0; layer < layers; ++layer) {
        const Point3 p{i + (slice % 2 == 0 ? 0 : 0.4), double(layer), gap * slice};
        if (keep(p)) points.push_back(p);
      }
    }
  }
  return points;
}

Points contours(double gap, int layers) {
  return contours(gap, layers, [](const Point3&) { return true; });
}

TEST(LocalSpacing, OfEvenSamplesIsTheDistanceOfTheSixthNeighbor) {
  EXPECT_FLOAT_EQ(spacing_at_origin(plane_lattice(1, 0, 1)), std::sqrt(2.0F));
  EXPECT_FLOAT_EQ(spacing_at_origin(turned(plane_lattice(1, 0, 1))), std::sqrt(2.0F));
  EXPECT_FLOAT_EQ(spacing_at_origin(plane_lattice(1, 0.5, std::sqrt(0.75))), 1);
  EXPECT_FLOAT_EQ(spacing_at_origin(turned(plane_lattice(3, 1.5, 3 * std::sqrt(0.75)))), 3);
}

TEST(LocalSpacing, OfContoursReachesTheNextSlices) {
  for (const double gap : {1.0, 2.0, 3.0, 4.0, 5.0, 8.0}) {
    for (const bool is_turned : {false, true}) {
      const Points points = contours(gap, 1);
      const float spacing = spacing_at_origin(is_turned ? turned(points) : points);
      EXPECT_GE(spacing, static_cast<float>(gap)) << gap;
      EXPECT_LE(spacing, std::max(1.5, gap + 0.1)) << gap;
    }
  }
}

TEST(LocalSpacing, OfContoursOnTheLastSliceReachesTheOneBeside) {
  for (const double gap : {4.0, 5.0}) {
    const float spacing =
        spacing_at_origin(turned(contours(gap, 1, [](const Point3& p) { return p.z >= 0; })));
    EXPECT_GE(spacing, static_cast<float>(gap));
    EXPECT_LE(spacing, gap + 0.1);
  }
}

TEST(LocalSpacing, OfShellsTwoLayersThickIsThatAlongTheShell) {
  Points shell = plane_lattice(1, 0, 1);
  for (const Point3& p : plane_lattice(1, 0, 1)) shell.push_back({p.x, p.y, 1});
  EXPECT_LE(spacing_at_origin(shell), std::sqrt(2.0F));
  EXPECT_GE(spacing_at_origin(shell), 1);
  for (const double gap : {2.0, 4.0, 5.0}) {
    const float spacing = spacing_at_origin(contours(gap, 2));
    EXPECT_GE(spacing, static_cast<float>(gap));
    EXPECT_LE(spacing, gap + 0.2);
  }
}

TEST(LocalSpacing, IsNotToldByWhatStandsStraightAboveTheSurface) {
  Points points = contours(4, 1);
  points.push_back({0.02, 0.9, 0.3});
  points.push_back({0.02, -0.9, -0.3});
  EXPECT_GE(spacing_at_origin(points), 4);
}

TEST(LocalSpacing, OfRimsAndCornersIsThatOfTheSamplesBeside) {
  for (const bool is_corner : {false, true}) {
    Points points;
    for (const Point3& p : plane_lattice(1, 0, 1)) {
      if (p.x >= 0 && (!is_corner || p.y >= 0)) points.push_back(p);
    }
    const float spacing = spacing_at_origin(turned(points));
    EXPECT_GE(spacing, std::sqrt(2.0F));
    EXPECT_LE(spacing, is_corner ? 2.3F : 2.0F);
  }
}

TEST(LocalSpacing, OfPointsOnALineIsTheDistanceOfTheSixthNeighbor) {
  for (const Point3& step : {Point3{1, 0, 0}, Point3{0, 0, 1}, Point3{0.1, -0.7, 0.3}}) {
    Points points;
    for (int i = -20; i <= 20; ++i) points.push_back(scaled(step, i));
    EXPECT_FLOAT_EQ(spacing_at_origin(points), static_cast<float>(3 * length(step)));
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

TEST(LocalSpacing, IsWithinTheNeighborsGiven) {
  for (const families::Family& family : families::all()) {
    std::mt19937_64 random(5);
    Points points(100);
    for (Point3& p : points) p = family.draw(random);
    const Point3 sample = points.back();
    Points vectors;
    for (const Point3& p : points) {
      if (!(p == sample)) vectors.push_back(minus(p, sample));
    }
    if (vectors.empty()) continue;
    std::sort(vectors.begin(), vectors.end(),
              [](const Point3& a, const Point3& b) { return dot(a, a) < dot(b, b); });
    vectors.resize(std::min(vectors.size(), kSpacingNeighbors));
    const float spacing = local_spacing(vectors);
    const double least = length(vectors[std::min<std::size_t>(vectors.size(), 6) - 1]);
    constexpr double kLeastFloat = std::numeric_limits<float>::min();
    EXPECT_GE(spacing, std::max(kLeastFloat, 0.999999 * least)) << family.name;
    EXPECT_LE(spacing, std::max(kLeastFloat, 1.000001 * length(vectors.back()))) << family.name;
  }
}

/// Gaps of more than 150 degrees, the plain way.
std::size_t wide_gaps(std::vector<double> degrees) {
  std::sort(degrees.begin(), degrees.end());
  std::size_t count = 0;
  for (std::size_t i = 0; i < degrees.size(); ++i) {
    const double next = i + 1 < degrees.size() ? degrees[i + 1] : degrees[0] + 360;
    count += next - degrees[i] > 150 ? 1 : 0;
  }
  return count;
}

TEST(DirectionGaps, AreThoseOfTheSortedDirections) {
  std::mt19937_64 random(6);
  for (int run = 0; run < 2000; ++run) {
    DirectionGaps gaps;
    std::vector<double> degrees;
    const int step = run % 2 == 0 ? 1 : 45;
    const int range = run % 3 == 0 ? 180 : 360;
    for (int i = 0; i < 12; ++i) {
      // Never at the threshold, where rounding decides.
      degrees.push_back(double(random() % (range / step)) * step + (step == 1 ? 0.01 * i : 0));
      const double radians = degrees.back() / 180 * std::acos(-1.0);
      gaps.add(std::cos(radians), std::sin(radians));
      ASSERT_EQ(gaps.wide(), wide_gaps(degrees)) << run << " " << i;
    }
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
