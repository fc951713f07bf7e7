// The eight points around a cloud.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <set>

#include "engine/order/far_points.h"
#include "tests/point_families.h"

namespace stream_recon {
namespace {

Box3 box_of(const Point3& low, const Point3& high) {
  Box3 box;
  box.extend(low);
  box.extend(high);
  return box;
}

std::array<double, 3> coordinates(const Point3& p) {
  return {p.x, p.y, p.z};
}

/// They are the corners of a cube whose half edge is a power of two; that half edge.
double expect_cube(const std::array<Point3, 8>& corners) {
  EXPECT_EQ(std::set<Point3>(corners.begin(), corners.end()).size(), 8U);
  Box3 cube;
  for (const Point3& p : corners) cube.extend(p);
  const double edge = cube.high.x - cube.low.x;
  EXPECT_EQ(edge, cube.high.y - cube.low.y);
  EXPECT_EQ(edge, cube.high.z - cube.low.z);
  int exponent = 0;
  EXPECT_EQ(std::frexp(edge, &exponent), 0.5) << edge;
  for (const Point3& p : corners) {
    for (const double x : coordinates(p)) {
      EXPECT_TRUE(x == cube.low.x || x == cube.high.x || x == cube.low.y || x == cube.high.y ||
                  x == cube.low.z || x == cube.high.z);
      EXPECT_EQ(std::nearbyint(x / (edge / 16)), x / (edge / 16)) << "not a short fraction";
    }
  }
  return edge / 2;
}

/// The box and a share of its extent around it lie inside.
void expect_around(const std::array<Point3, 8>& corners, const Box3& box, double half_edge) {
  Box3 cube;
  for (const Point3& p : corners) cube.extend(p);
  const double around = half_edge / 2;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    EXPECT_LE(coordinates(cube.low)[axis], coordinates(box.low)[axis] - around);
    EXPECT_GE(coordinates(cube.high)[axis], coordinates(box.high)[axis] + around);
  }
}

TEST(FarPoints, AreTheCornersOfACubeFarAroundAnyBox) {
  std::mt19937_64 random(1);
  for (int i = 0; i < 1000; ++i) {
    const double scale = std::ldexp(1.0, static_cast<int>(random() % 200) - 100);
    const double away = std::ldexp(scale, static_cast<int>(random() % 30));
    const auto draw = [&](const Point3& around) {
      const Point3 p = families::random_point(random);
      return Point3{scale * p.x + away * around.x, scale * p.y + away * around.y,
                    scale * p.z + away * around.z};
    };
    const Point3 middle = families::random_point(random);
    const Box3 box = box_of(draw(middle), draw(middle));
    const auto corners = far_points(box);
    const double half_edge = expect_cube(corners);
    EXPECT_GE(half_edge, 2.5 * box.extent());
    EXPECT_LT(half_edge, 5 * box.extent());
    expect_around(corners, box, half_edge);
    EXPECT_EQ(far_points(box), corners);
  }
}

TEST(FarPoints, OfAPointOrALineOrAPlaneAreAroundItToo) {
  const Point3 p{3.25, -7, 1e-3};
  const Box3 point = box_of(p, p);
  EXPECT_EQ(expect_cube(far_points(point)), 4);
  expect_around(far_points(point), point, 4);
  const Box3 line = box_of(p, {p.x, p.y + 1, p.z});
  EXPECT_EQ(expect_cube(far_points(line)), 4);
  expect_around(far_points(line), line, 4);
  const Box3 plane = box_of(p, {p.x + 0.8, p.y, p.z + 0.1});
  EXPECT_EQ(expect_cube(far_points(plane)), 2);
  expect_around(far_points(plane), plane, 2);
}

TEST(FarPoints, OfABoxOfAFewRoundingsFarAwayHoldIt) {
  const double next = std::nextafter(1e6, 2e6);
  const Box3 box = box_of({1e6, -1e6, 1e6}, {next, -1e6, next});
  Box3 cube;
  for (const Point3& p : far_points(box)) cube.extend(p);
  EXPECT_LT(cube.low.x, box.low.x);
  EXPECT_LT(cube.low.y, box.low.y);
  EXPECT_GT(cube.high.x, box.high.x);
  EXPECT_GT(cube.high.y, box.high.y);
}

}  // namespace
}  // namespace stream_recon
