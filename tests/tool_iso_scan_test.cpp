#include "tools/sampling/iso_scan.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <set>
#include <tuple>
#include <vector>

#include "tests/array_volume.h"
#include "tools/sampling/placement.h"
#include "tools/sampling/region_grid.h"

namespace stream_recon {
namespace {

std::vector<Point3> crossings(Volume& volume, double value) {
  const GridBox whole{{0, 0, 0}, volume.geometry().size};
  PlacementOptions options;
  options.region = whole;
  const Placement placement(volume.geometry(), options);
  RegionGrid grid(volume, whole, {1, 1, 1});
  std::vector<Point3> points;
  IsoScan scan(grid, value, [&](const GridPoint& p) { points.push_back(placement.position(p)); });
  const std::uint64_t count = scan.run();
  EXPECT_EQ(count, points.size());
  return points;
}

using Points = std::vector<Point3>;

TEST(IsoScan, CrossAtTheInterpolatedPlace) {
  ArrayVolume row({3, 1, 1}, {0, 10, 20});
  EXPECT_EQ(crossings(row, 5), (Points{{0.5, 0, 0}}));
  EXPECT_EQ(crossings(row, 17.5), (Points{{1.75, 0, 0}}));
  EXPECT_EQ(crossings(row, 21), Points{});
  EXPECT_EQ(crossings(row, -1), Points{});
  ArrayVolume falling({1, 1, 2}, {8, 0});
  EXPECT_EQ(crossings(falling, 2), (Points{{0, 0, 0.75}}));
}

TEST(IsoScan, SpacingOriginAndDirectionApply) {
  ArrayVolume row({1, 2, 1}, {0, 4});
  row.change().origin = {100, 200, 300};
  row.change().step[1] = {0, 0, -2};
  EXPECT_EQ(crossings(row, 1), (Points{{100, 200, 299.5}}));
}

TEST(IsoScan, AVoxelOfTheValueItselfComesOnce) {
  std::vector<double> values(27, 0);
  values[13] = 7;  // the middle of 3 x 3 x 3, six edges reach it
  ArrayVolume volume({3, 3, 3}, values);
  EXPECT_EQ(crossings(volume, 7), (Points{{1, 1, 1}}));
}

TEST(IsoScan, AVoxelOfTheValueWithoutALowerNeighborIsNoCrossing) {
  ArrayVolume row({3, 1, 1}, {7, 7, 9});
  EXPECT_EQ(crossings(row, 7), Points{});
}

TEST(IsoScan, VoxelsThatAreNotFiniteCrossNothing) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  ArrayVolume row({6, 1, 1}, {0, nan, 10, infinity, -infinity, 5});
  EXPECT_EQ(crossings(row, 5), Points{});
}

TEST(IsoScan, HugeVoxelsDoNotOverflow) {
  const double huge = std::numeric_limits<double>::max();
  ArrayVolume row({2, 1, 1}, {-huge, huge});
  EXPECT_EQ(crossings(row, 0), (Points{{0.5, 0, 0}}));
}

// Small integers make voxels that equal the value common.
TEST(IsoScan, RandomVolumesAgreeWithEveryEdgeByItselfAndRepeatNothing) {
  for (int seed = 0; seed < 200; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed);
    const auto side = [&] { return std::size_t{1 + random() % 5}; };
    const std::array<std::size_t, 3> size{side(), side(), side()};
    std::vector<double> values(size[0] * size[1] * size[2]);
    for (double& value : values) value = static_cast<double>(random() % 5);
    ArrayVolume volume(size, values);

    std::set<std::tuple<double, double, double>> expected;
    const auto edge = [&](std::array<std::size_t, 3> from, int axis) {
      std::array<std::size_t, 3> to = from;
      if (++to[axis] == size[axis]) return;
      const double a = volume.at(from[0], from[1], from[2]);
      const double b = volume.at(to[0], to[1], to[2]);
      if ((a >= 2) == (b >= 2)) return;
      std::array<double, 3> p{double(from[0]), double(from[1]), double(from[2])};
      p[axis] += (2 - a) / (b - a);
      expected.emplace(p[0], p[1], p[2]);
    };
    for (std::size_t k = 0; k < size[2]; ++k)
      for (std::size_t j = 0; j < size[1]; ++j)
        for (std::size_t i = 0; i < size[0]; ++i)
          for (int axis = 0; axis < 3; ++axis) edge({i, j, k}, axis);

    std::set<std::tuple<double, double, double>> found;
    for (const Point3& p : crossings(volume, 2))
      EXPECT_TRUE(found.emplace(p.x, p.y, p.z).second) << "repeated";
    EXPECT_EQ(found, expected);
  }
}

TEST(IsoScan, CrossingsHardlyOffAVoxelStayDistinct) {
  std::vector<double> values(27, 0);
  values[13] = 1e300;
  ArrayVolume volume({3, 3, 3}, values);
  volume.change().origin = {100, 100, 100};
  const auto points = crossings(volume, std::nextafter(1e300, 0));
  std::set<std::tuple<double, double, double>> distinct;
  for (const Point3& p : points) distinct.emplace(p.x, p.y, p.z);
  EXPECT_EQ(points.size(), 6U);
  EXPECT_EQ(distinct.size(), 6U);
}

}  // namespace
}  // namespace stream_recon
