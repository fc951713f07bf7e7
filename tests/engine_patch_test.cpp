// Patches fit their holes exactly, whatever the crust; and where the crust is good they use it.

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "engine/hybrid/hole_rings.h"
#include "engine/hybrid/patch.h"
#include "tests/hole_shapes.h"

namespace stream_recon {
namespace {

using shapes::Random;
using shapes::Region;
using shapes::Surface;

/// What the caller relies on.
void expect_fits(const Patch& patch, const Hole& hole) {
  if (patch.kind == PatchKind::kNone) {
    EXPECT_TRUE(patch.triangles.empty());
    return;
  }
  EXPECT_EQ(shapes::boundary(patch.triangles), shapes::boundary(hole.fills));
  EXPECT_LE(shapes::most_at_an_edge(patch.triangles), 2);
  std::set<std::uint32_t> used;
  std::set<std::set<std::uint32_t>> distinct;
  for (const HoleTriangle& t : patch.triangles) {
    used.insert(t.begin(), t.end());
    distinct.emplace(t.begin(), t.end());
    EXPECT_EQ((std::set<std::uint32_t>(t.begin(), t.end()).size()), 3U);
  }
  EXPECT_LT(*used.rbegin(), hole.points.size()) << "a vertex was added";
  EXPECT_EQ(distinct.size(), patch.triangles.size());
  EXPECT_EQ(used.size() + patch.unused_samples, hole.points.size());
}

Region cap(double height) {
  return [=](const Point3& p) { return p.z > height; };
}

/// A crust of the sphere, about `16 / 4^coarser` vertices a sample.
struct SphereCase {
  Hole hole;
  Surface crust;
};

SphereCase sphere_case(std::uint64_t seed, double height, int coarser = 0) {
  Random random(seed);
  const Surface samples = shapes::sphere(3, 0.2, random);
  return {shapes::hole(samples, cap(height)),
          shapes::part(shapes::sphere(5 - coarser, 0.2, random), cap(height - 0.4))};
}

TEST(Patch, FitsACapOfASphere) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const SphereCase c = sphere_case(seed, 0.3);
    const Patch patch = make_patch(c.hole, c.crust);
    EXPECT_EQ(patch.kind, PatchKind::kCrust);
    expect_fits(patch, c.hole);
    EXPECT_EQ(patch.unused_samples, 0U);
    EXPECT_EQ(patch.triangles.size(), c.hole.fills.size()) << "the Euler number of a disc";
  }
}

TEST(Patch, FacesOutwardAsTheCrustDoes) {
  const SphereCase c = sphere_case(5, 0.3);
  const Patch patch = make_patch(c.hole, c.crust);
  ASSERT_EQ(patch.kind, PatchKind::kCrust);
  for (const HoleTriangle& t : patch.triangles) {
    const Point3& a = c.hole.points[t[0]];
    const Point3 normal = cross(minus(c.hole.points[t[1]], a), minus(c.hole.points[t[2]], a));
    EXPECT_GT(dot(normal, a), 0);
  }
}

TEST(Patch, FitsAnAnnulusAndABandAroundATorus) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const Surface samples = shapes::torus(40, 18, 0.2, random);
    const Surface crust = shapes::torus(101, 47, 0.2, random);
    const Hole annulus = shapes::hole(samples, [](const Point3& p) {
      const double d = std::hypot(p.x - 1.2, p.y, p.z);
      return d > 0.3 && d < 0.7;
    });
    const Hole band = shapes::hole(samples, [](const Point3& p) { return p.x > 0.3 && p.y > 0; });
    for (const Hole* hole : {&annulus, &band}) {
      const Patch patch = make_patch(*hole, crust);
      EXPECT_EQ(patch.kind, PatchKind::kCrust);
      expect_fits(patch, *hole);
    }
    EXPECT_EQ(hole_rings(band).size(), 2U);
  }
}

TEST(Patch, FitsATorusWithAHandleInTheHole) {
  Random random(3);
  const Surface samples = shapes::torus(40, 18, 0.2, random);
  const Surface crust = shapes::torus(101, 47, 0.2, random);
  const Hole hole = shapes::hole(samples, [](const Point3& p) { return p.x > -1.2; });
  ASSERT_EQ(hole_rings(hole).size(), 1U);
  const Patch patch = make_patch(hole, crust);
  EXPECT_EQ(patch.kind, PatchKind::kCrust);
  expect_fits(patch, hole);
  EXPECT_EQ(patch.triangles.size(), hole.fills.size()) << "the handle is there";
}

TEST(Patch, SmallHolesHaveTheirOnlyTriangle) {
  const SphereCase c = sphere_case(2, 0.3);
  const HoleTriangle& fill = c.hole.fills[7];
  const Hole hole{{c.hole.points[fill[0]], c.hole.points[fill[1]], c.hole.points[fill[2]]},
                  {{0, 1, 2}}};
  const Patch patch = make_patch(hole, c.crust);
  EXPECT_EQ(patch.triangles, hole.fills);
  const auto closed = close_by_triangles(hole);
  ASSERT_TRUE(closed);
  EXPECT_EQ(closed->kind, PatchKind::kTriangles);
  EXPECT_EQ(closed->triangles, hole.fills);
}

TEST(Patch, ACrustThatIsNotThereGivesNoneOrTriangles) {
  const SphereCase large = sphere_case(4, 0.3);
  EXPECT_EQ(make_patch(large.hole, {}).kind, PatchKind::kNone);
  const Hole four{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 3}}};
  const Patch patch = make_patch(four, {});
  EXPECT_EQ(patch.kind, PatchKind::kTriangles);
  expect_fits(patch, four);
}

TEST(Patch, AtAGapOfTheCrustFillsAreKept) {
  const SphereCase c = sphere_case(6, 0.3);
  const Surface torn =
      shapes::part(c.crust, [](const Point3& p) { return std::hypot(p.x, p.y) > 0.1; });
  ASSERT_LT(torn.triangles.size(), c.crust.triangles.size());
  const Patch patch = make_patch(c.hole, torn);
  EXPECT_EQ(patch.kind, PatchKind::kCrust);
  EXPECT_GT(patch.kept_fills, 0U);
  EXPECT_LT(patch.kept_fills, c.hole.fills.size() / 3);
  expect_fits(patch, c.hole);
  const Surface rim = shapes::part(c.crust, [](const Point3& p) { return p.z < 0.6; });
  EXPECT_EQ(make_patch(c.hole, rim).kind, PatchKind::kNone);
}

TEST(Patch, ACrustTurnedInsideOutGivesNone) {
  SphereCase c = sphere_case(6, 0.3);
  for (auto& t : c.crust.triangles) std::swap(t[0], t[1]);
  EXPECT_EQ(make_patch(c.hole, c.crust).kind, PatchKind::kNone);
}

TEST(Patch, TheOtherSideOfAThinWallIsNotTaken) {
  SphereCase c = sphere_case(8, 0.3);
  const auto near = static_cast<std::uint32_t>(c.crust.points.size());
  const auto outer = c.crust.triangles;
  for (std::uint32_t i = 0; i < near; ++i) {
    c.crust.points.push_back(scaled(c.crust.points[i], 0.995));
  }
  for (const auto& t : outer) {
    c.crust.triangles.push_back({t[1] + near, t[0] + near, t[2] + near});
  }
  const Patch patch = make_patch(c.hole, c.crust);
  EXPECT_EQ(patch.kind, PatchKind::kCrust);
  expect_fits(patch, c.hole);
}

TEST(Patch, AClosedHoleHasNone) {
  Random random(1);
  const Surface s = shapes::sphere(2, 0.1, random);
  EXPECT_EQ(make_patch({s.points, s.triangles}, s).kind, PatchKind::kNone);
}

TEST(Patch, TheSameForTheSame) {
  const SphereCase c = sphere_case(9, 0.2, 1);
  EXPECT_EQ(make_patch(c.hole, c.crust).triangles, make_patch(c.hole, c.crust).triangles);
}

/// Damages a crust at random places.
void damage(Surface& crust, Random& random) {
  std::uniform_real_distribution<double> any(-1, 1);
  const auto kind = random() % 6;
  const std::size_t times = 1 + random() % 4;
  for (std::size_t i = 0; i < times; ++i) {
    auto& t = crust.triangles[random() % crust.triangles.size()];
    Point3& p = crust.points[random() % crust.points.size()];
    if (kind == 0) t[random() % 3] ^= 1U << random() % 32;
    if (kind == 1) std::swap(t[0], t[1]);
    if (kind == 2) t = crust.triangles[random() % crust.triangles.size()];
    if (kind == 3) t[0] = t[1];
    if (kind == 4) p = {2 * any(random), 2 * any(random), 2 * any(random)};
    if (kind == 5) p.x = std::nan("");
  }
}

TEST(Patch, WhateverTheCrustTheBorderIsTheRing) {
  int whole = 0;
  int torn = 0;
  for (std::uint64_t seed = 1; seed <= 150; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    SphereCase c = sphere_case(seed, 0.4 + 0.1 * static_cast<double>(seed % 6), 1);
    damage(c.crust, random);
    const Patch patch = make_patch(c.hole, c.crust);
    expect_fits(patch, c.hole);
    if (patch.kind == PatchKind::kCrust && patch.kept_fills == 0) ++whole;
    if (patch.kind != PatchKind::kCrust || patch.kept_fills > 0) ++torn;
  }
  EXPECT_GT(whole, 20) << "patches from the crust";
  EXPECT_GT(torn, 5) << "the damage was felt";
}

TEST(Patch, SoupGivesNoCrack) {
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    SphereCase c = sphere_case(seed, 0.8);
    for (auto& t : c.crust.triangles) {
      for (auto& v : t) {
        if (random() % 20 == 0) v = static_cast<std::uint32_t>(random() % c.crust.points.size());
      }
    }
    expect_fits(make_patch(c.hole, c.crust), c.hole);
  }
}

TEST(Patch, ATunnelOfTheCrustCostsFillsAroundItOnly) {
  // From the region inside the hole to the crust outside, through the ball.
  SphereCase c = sphere_case(6, 0.3);
  Random random(11);
  c.crust = shapes::sphere(5, 0.2, random);
  const auto mouth = [&](double sign) {
    std::size_t best = 0;
    for (std::size_t t = 0; t < c.crust.triangles.size(); ++t) {
      const auto z = [&](std::size_t i) {
        return sign * shapes::middle(c.crust, c.crust.triangles[i]).z;
      };
      if (z(t) > z(best)) best = t;
    }
    return c.crust.triangles[best];
  };
  const auto a = mouth(1), b = mouth(-1);
  std::erase(c.crust.triangles, a);
  std::erase(c.crust.triangles, b);
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    c.crust.triangles.push_back({a[i], a[j], b[2 - i]});
    c.crust.triangles.push_back({a[j], b[2 - j], b[2 - i]});
  }
  const Patch patch = make_patch(c.hole, c.crust);
  EXPECT_EQ(patch.kind, PatchKind::kCrust);
  EXPECT_GT(patch.kept_fills, 0U);
  expect_fits(patch, c.hole);
}

TEST(CloseByTriangles, RefusesSamplesInsideSeveralRingsAndLongOnes) {
  const Hole star{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-1, -1, 0}},
                  {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}}};
  EXPECT_FALSE(close_by_triangles(star));
  Random random(1);
  const Hole band = shapes::hole(shapes::torus(10, 3, 0, random),
                                 [](const Point3& p) { return p.x > 0 && p.y > 0; });
  EXPECT_FALSE(close_by_triangles(band));
  Hole fan;
  for (std::uint32_t i = 0; i < kMostRingEdges + 1; ++i) {
    const double a = 2 * std::numbers::pi * i / (kMostRingEdges + 1);
    fan.points.push_back({std::cos(a), std::sin(a), 0});
    if (i > 1) fan.fills.push_back({0, i - 1, i});
  }
  EXPECT_FALSE(close_by_triangles(fan));
  fan.points.pop_back();
  fan.fills.pop_back();
  const auto closed = close_by_triangles(fan);
  ASSERT_TRUE(closed);
  expect_fits(*closed, fan);
}

}  // namespace
}  // namespace stream_recon
