#include "tools/preview/depth_buffer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "tools/preview/cells.h"
#include "tools/preview/occlusion.h"
#include "tools/preview/view.h"

namespace stream_recon {
namespace {

using Triangle = std::array<ScreenVertex, 3>;

Triangle facing(Vector3f a, Vector3f b, Vector3f c) {
  return {{{a, {0, 0, 1}}, {b, {0, 0, 1}}, {c, {0, 0, 1}}}};
}

std::size_t covered(const DepthBuffer& buffer) {
  std::size_t count = 0;
  for (std::size_t y = 0; y < buffer.height(); ++y)
    for (std::size_t x = 0; x < buffer.width(); ++x)
      count += buffer.depth(x, y) != DepthBuffer::kNothing ? 1 : 0;
  return count;
}

TEST(DepthBuffer, CoversTheSampleCentresInsideATriangle) {
  DepthBuffer buffer(8, 8);
  buffer.draw(facing({0, 0, 1}, {8, 0, 1}, {0, 8, 1}));
  for (std::size_t y = 0; y < 8; ++y)
    for (std::size_t x = 0; x < 8; ++x)
      EXPECT_EQ(buffer.depth(x, y) == 1, x + y + 1 <= 8) << x << ' ' << y;
}

TEST(DepthBuffer, NeighboursLeaveNoGap) {
  for (unsigned seed = 0; seed < 50; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> place(4, 28);
    const Vector3f hub{place(random), place(random), 0};
    DepthBuffer buffer(32, 32);
    const Vector3f corners[4] = {{-1, -1, 0}, {33, -1, 0}, {33, 33, 0}, {-1, 33, 0}};
    for (int i = 0; i < 4; ++i) buffer.draw(facing(hub, corners[i], corners[(i + 1) % 4]));
    EXPECT_EQ(covered(buffer), 32U * 32U);
  }
}

TEST(DepthBuffer, TheNearestSurfaceWinsInAnyOrder) {
  std::vector<Triangle> triangles;
  for (const float z : {3.0F, 7.0F, 5.0F})
    triangles.push_back(facing({0, 0, z}, {20, 0, z}, {0, 20, z}));
  for (int order = 0; order < 6; ++order) {
    DepthBuffer buffer(4, 4);
    for (const Triangle& triangle : triangles) buffer.draw(triangle);
    EXPECT_FLOAT_EQ(buffer.depth(1, 1), 7);
    std::next_permutation(triangles.begin(), triangles.end(), [](const auto& a, const auto& b) {
      return a[0].position.z < b[0].position.z;
    });
  }
}

TEST(DepthBuffer, DepthAndNormalAreInterpolated) {
  DepthBuffer buffer(4, 4);
  buffer.draw({{{{0, 0, 0}, {0, 0, 1}}, {{8, 0, 8}, {1, 0, 0}}, {{0, 8, 0}, {0, 0, 1}}}});
  EXPECT_NEAR(buffer.depth(3, 0), 3.5, 1e-5);
  const Vector3f n = buffer.normal(3, 0);
  EXPECT_NEAR(n.x / n.z, 3.5 / 4.5, 1e-3);
  EXPECT_NEAR(n.x * n.x + n.y * n.y + n.z * n.z, 1, 1e-3);
}

TEST(DepthBuffer, WhatHasNoAreaOrNoPlaceDrawsNothing) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const float infinity = std::numeric_limits<float>::infinity();
  DepthBuffer buffer(4, 4);
  buffer.draw(facing({0, 0, 0}, {2, 2, 0}, {4, 4, 0}));
  buffer.draw(facing({1, 1, 0}, {1, 1, 0}, {1, 1, 0}));
  buffer.draw(facing({100, 100, 0}, {200, 100, 0}, {100, 200, 0}));
  buffer.draw(facing({-9, -9, 0}, {-8, -9, 0}, {-9, -8, 0}));
  buffer.draw(facing({0, 0, nan}, {8, 0, nan}, {0, 8, nan}));
  buffer.draw(facing({nan, 0, 0}, {8, 0, 0}, {0, 8, 0}));
  buffer.draw(facing({0, 0, 0}, {infinity, 0, 0}, {0, infinity, 0}));
  EXPECT_EQ(covered(buffer), 0U);
}

// A flat floor, and the same floor with a wall beside it.
TEST(SkyVisibility, AWallHidesSkyFromTheFloorNextToIt) {
  DepthBuffer open(128, 128);
  open.draw(facing({-1, -1, 0}, {300, -1, 0}, {-1, 300, 0}));
  DepthBuffer walled = open;
  walled.draw(facing({64, -1, 10}, {300, -1, 10}, {64, 300, 10}));
  const auto at_wall = [](const DepthBuffer& buffer) {
    return sky_visibility(Cells(buffer))[32 * 64 + 30];
  };
  EXPECT_EQ(at_wall(open), 1);
  EXPECT_LT(at_wall(walled), 0.8);
  EXPECT_GT(at_wall(walled), 0.2);
}

TEST(View, NamedViewsLookFromWhereTheySay) {
  const auto toward = [](const char* name) { return parse_view(name).toward; };
  const auto is = [](const Point3& a, const Point3& b) {
    return std::hypot(a.x - b.x, a.y - b.y, a.z - b.z) < 1e-12;
  };
  EXPECT_TRUE(is(toward("front"), {0, -1, 0}));
  EXPECT_TRUE(is(toward("back"), {0, 1, 0}));
  EXPECT_TRUE(is(toward("left"), {1, 0, 0}));
  EXPECT_TRUE(is(toward("right"), {-1, 0, 0}));
  EXPECT_TRUE(is(toward("top"), {0, 0, 1}));
  EXPECT_TRUE(is(toward("bottom"), {0, 0, -1}));
}

TEST(View, AxesAreRightHandedAndOrthonormal) {
  for (const char* text : {"front", "left", "top", "30,20", "-135.5,-77", "0,90"}) {
    SCOPED_TRACE(text);
    const View v = parse_view(text);
    const Point3 cross{v.right.y * v.up.z - v.right.z * v.up.y,
                       v.right.z * v.up.x - v.right.x * v.up.z,
                       v.right.x * v.up.y - v.right.y * v.up.x};
    EXPECT_NEAR(std::hypot(cross.x - v.toward.x, cross.y - v.toward.y, cross.z - v.toward.z), 0,
                1e-12);
    EXPECT_NEAR(std::hypot(v.toward.x, v.toward.y, v.toward.z), 1, 1e-12);
    EXPECT_GE(v.up.z, -1e-12);
  }
}

TEST(View, NonsenseIsRefused) {
  for (const char* text : {"", "above", "1", "1,", "1,2,3", "1;2", "400,0", "0,91", "nan,0"})
    EXPECT_THROW(parse_view(text), std::invalid_argument) << text;
}

}  // namespace
}  // namespace stream_recon
