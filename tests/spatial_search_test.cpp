// What a search over the index relies on: bounds of nodes that hold their points, and a test of
// many balls against them that drops none that matters.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include "spatial/node_bounds.h"
#include "tests/point_families.h"

namespace stream_recon {
namespace {

using Long = long double;
using LongVector = std::array<Long, 3>;
using Points = std::vector<Point3>;

constexpr Long kRounding = 16 * std::numeric_limits<Long>::epsilon();
constexpr unsigned kSeeds = 20;

LongVector minus(const Point3& a, const Point3& b) {
  return {Long{a.x} - Long{b.x}, Long{a.y} - Long{b.y}, Long{a.z} - Long{b.z}};
}

Long dot(const LongVector& a, const LongVector& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

LongVector cross(const LongVector& a, const LongVector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

Long length(const LongVector& v) {
  return std::sqrt(dot(v, v));
}

Point3 scaled(const Point3& p, double s) {
  return {p.x * s, p.y * s, p.z * s};
}

Point3 sum(const Point3& a, const Point3& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}

/// Shapes of what a node holds, besides those that are hard for predicates.
std::vector<families::Family> shapes() {
  std::vector<families::Family> list = families::all();
  list.push_back({"collinear", [](std::mt19937_64& r) {
                    return scaled({0.3, -0.7, 0.2}, families::random_point(r).x);
                  }});
  list.push_back({"one place", [](std::mt19937_64&) { return Point3{0.1, 0.2, 0.3}; }});
  list.push_back(
      {"1e-30", [](std::mt19937_64& r) { return scaled(families::random_point(r), 1e-30); }});
  list.push_back(
      {"1e30", [](std::mt19937_64& r) { return scaled(families::random_point(r), 1e30); }});
  list.push_back({"offset", [](std::mt19937_64& r) {
                    return sum({1e6, -1e6, 1e6}, scaled(families::random_point(r), 1e-6));
                  }});
  list.push_back({"tilted patch", [](std::mt19937_64& r) {
                    const Point3 p = families::random_point(r);
                    return Point3{p.x, p.y, 0.4 * p.x - 0.8 * p.y + 1e-4 * p.z};
                  }});
  return list;
}

/// Points with an origin as the index has one, and the largest of all their coordinates.
struct Cloud {
  Points points;
  Points relative;
  Point3 origin;
  double reach = 0;
};

Cloud draw(const families::Family& family, std::size_t count, std::mt19937_64& random) {
  Cloud cloud;
  cloud.origin = family.draw(random);
  const auto extend = [&cloud](const Point3& p) {
    cloud.reach = std::max({cloud.reach, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
  };
  extend(cloud.origin);
  for (std::size_t i = 0; i < count; ++i) {
    const Point3 p = family.draw(random);
    const Point3& o = cloud.origin;
    cloud.points.push_back(p);
    cloud.relative.push_back({p.x - o.x, p.y - o.y, p.z - o.z});
    extend(p);
    extend(cloud.relative.back());
  }
  return cloud;
}

Point3 vector(const float (&v)[3]) {
  return {v[0], v[1], v[2]};
}

LongVector exactly(const Point3& p) {
  return minus(p, {});
}

/// u, w and z with v = u rows[0] + w rows[1] + z normal.
LongVector in_patch(const NodeBounds& bounds, const LongVector& v) {
  const LongVector a = exactly(vector(bounds.rows[0]));
  const LongVector b = exactly(vector(bounds.rows[1]));
  const LongVector n = exactly(vector(bounds.normal));
  const Long volume = dot(a, cross(b, n));
  return {dot(v, cross(b, n)) / volume, dot(v, cross(n, a)) / volume, dot(v, cross(a, b)) / volume};
}

/// Of the axes that the patch is described in.
void expect_good_axes(const NodeBounds& bounds) {
  const LongVector n = exactly(vector(bounds.normal));
  std::array<LongVector, 2> axes{exactly(vector(bounds.rows[0])), exactly(vector(bounds.rows[1]))};
  for (int i = 0; i < 2; ++i) {
    const Long slope = dot(axes[i], n);
    ASSERT_LT(std::abs(slope), 1);
    for (int k = 0; k < 3; ++k) axes[i][k] -= slope * n[k];
    ASSERT_NEAR(double(dot(axes[i], axes[i])), 1, NodeBounds::kAxesError);
    ASSERT_NEAR(double(dot(axes[i], n)), 0, NodeBounds::kAxesError);
    ASSERT_LE(std::abs(bounds.curvature[i] * bounds.extent[i]), 1);
  }
  ASSERT_NEAR(double(dot(axes[0], axes[1])), 0, NodeBounds::kAxesError);
  ASSERT_NEAR(double(dot(n, n)), 1, NodeBounds::kAxesError);
}

void expect_holds(const NodeBounds& bounds, const Cloud& cloud, std::size_t i) {
  const LongVector p = minus(cloud.points[i], cloud.origin);
  for (int axis = 0; axis < 3; ++axis) {
    ASSERT_LE(Long{bounds.low[axis]}, p[axis]) << "point " << i << ", axis " << axis;
    ASSERT_GE(Long{bounds.high[axis]}, p[axis]) << "point " << i << ", axis " << axis;
  }
  ASSERT_NO_FATAL_FAILURE(expect_good_axes(bounds));
  const Point3 m = vector(bounds.middle);
  const LongVector v{p[0] - m.x, p[1] - m.y, p[2] - m.z};
  const Long tolerance = kRounding * length(v);
  const auto [u, w, z] = in_patch(bounds, v);
  ASSERT_LE(std::abs(u), bounds.extent[0] + tolerance) << "point " << i;
  ASSERT_LE(std::abs(w), bounds.extent[1] + tolerance) << "point " << i;
  const Long t = z - (bounds.curvature[0] * u * u + bounds.curvature[1] * w * w) / 2;
  ASSERT_GE(t, bounds.thick_low - tolerance) << "point " << i;
  ASSERT_LE(t, bounds.thick_high + tolerance) << "point " << i;
}

std::string trace(const families::Family& family, unsigned seed) {
  return family.name + ", seed " + std::to_string(seed);
}

TEST(NodeBounds, HoldEveryPoint) {
  for (const families::Family& family : shapes()) {
    for (unsigned seed = 0; seed < kSeeds; ++seed) {
      SCOPED_TRACE(trace(family, seed));
      std::mt19937_64 random(seed);
      const Cloud cloud = draw(family, 1 + random() % (seed % 2 ? 4 : 200), random);
      const NodeBounds bounds = bounds_of_points(cloud.relative, cloud.reach);
      ASSERT_FALSE(bounds.empty());
      for (std::size_t i = 0; i < cloud.points.size(); ++i) {
        ASSERT_NO_FATAL_FAILURE(expect_holds(bounds, cloud, i));
      }
    }
  }
}

TEST(NodeBounds, OfNodesHoldEveryPointTwoLevelsUp) {
  for (const families::Family& family : shapes()) {
    for (unsigned seed = 0; seed < kSeeds; ++seed) {
      SCOPED_TRACE(trace(family, seed));
      std::mt19937_64 random(seed);
      Cloud cloud = draw(family, 16 * 16, random);
      std::vector<NodeBounds> level;
      for (std::size_t leaf = 0; leaf < 16; ++leaf) {
        level.push_back(bounds_of_points({&cloud.relative[leaf * 16], 16}, cloud.reach));
      }
      while (level.size() > 1) {
        std::vector<NodeBounds> above;
        for (std::size_t i = 0; i < level.size(); i += 4) {
          above.push_back(bounds_of_nodes({&level[i], 4}, cloud.reach));
        }
        level = above;
        for (std::size_t i = 0; i < cloud.points.size(); ++i) {
          const NodeBounds& own = level[i * level.size() / cloud.points.size()];
          ASSERT_NO_FATAL_FAILURE(expect_holds(own, cloud, i)) << level.size() << " nodes";
        }
      }
    }
  }
}

TEST(NodeBounds, OfNothingAreEmptyAndAreIgnored) {
  SCOPED_TRACE("seed 5");
  EXPECT_TRUE(empty_bounds().empty());
  EXPECT_TRUE(bounds_of_points({}, 1).empty());
  EXPECT_TRUE(bounds_of_nodes({}, 1).empty());
  const std::array<NodeBounds, 4> none{empty_bounds(), empty_bounds(), empty_bounds(),
                                       empty_bounds()};
  EXPECT_TRUE(bounds_of_nodes(none, 1).empty());

  std::mt19937_64 random(5);
  const Cloud cloud = draw(families::all().front(), 16, random);
  const NodeBounds node = bounds_of_points(cloud.relative, cloud.reach);
  const NodeBounds alone = bounds_of_nodes({&node, 1}, cloud.reach);
  const std::array<NodeBounds, 4> mixed{empty_bounds(), node, empty_bounds(), empty_bounds()};
  const NodeBounds among = bounds_of_nodes(mixed, cloud.reach);
  for (std::size_t i = 0; i < cloud.points.size(); ++i) {
    ASSERT_NO_FATAL_FAILURE(expect_holds(among, cloud, i));
  }
  EXPECT_EQ(among.extent[0], alone.extent[0]);
  EXPECT_EQ(among.thick_low, alone.thick_low);
  EXPECT_EQ(among.thick_high, alone.thick_high);
}

/// Points in the order of a curve that fills the square, 16 for each of `leaves` squares.
Cloud draw_graph(int leaves_a_side, const std::function<double(double, double)>& height,
                 std::mt19937_64& random) {
  std::uniform_real_distribution<double> within(0, 1.0 / leaves_a_side);
  Cloud cloud;
  cloud.reach = 2;
  for (int leaf = 0; leaf < leaves_a_side * leaves_a_side; ++leaf) {
    for (int i = 0; i < 16; ++i) {
      const double x = static_cast<double>(leaf % leaves_a_side) / leaves_a_side + within(random);
      const double y = static_cast<double>(leaf / leaves_a_side) / leaves_a_side + within(random);
      cloud.points.push_back({x, y, height(x, y)});
    }
  }
  cloud.relative = cloud.points;
  return cloud;
}

TEST(NodeBounds, OfACurvedSurfaceAreThinAlsoOneLevelUp) {
  const auto bowl = [](double x, double y) { return 0.1 * x * x + 0.05 * x * y + 0.2 * y * y; };
  const auto saddle = [](double x, double y) { return 0.3 * x - 0.2 * y + 0.2 * x * y; };
  for (unsigned seed = 0; seed < kSeeds; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937_64 random(seed);
    const Cloud cloud = seed % 2 ? draw_graph(2, bowl, random) : draw_graph(2, saddle, random);
    std::vector<NodeBounds> nodes;
    for (int i = 0; i < 4; ++i) {
      nodes.push_back(bounds_of_points({&cloud.relative[i * 16], 16}, cloud.reach));
    }
    nodes.push_back(bounds_of_points(cloud.relative, cloud.reach));
    nodes.push_back(bounds_of_nodes({nodes.data(), 4}, cloud.reach));
    for (const NodeBounds& b : nodes) {
      const double diagonal = std::sqrt(squared_diagonal(b));
      // The node above takes what it knows from the patches below.
      const double share = &b == &nodes.back() ? 0.05 : 0.02;
      EXPECT_LT(b.thick_high - b.thick_low, share * diagonal) << &b - nodes.data();
      EXPECT_LT(b.extent[0], diagonal);
      EXPECT_LT(b.extent[1], diagonal);
    }
  }
}

}  // namespace
}  // namespace stream_recon
