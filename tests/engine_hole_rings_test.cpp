// The border of holes: every edge in one ring, and rings that touch do not cross.

#include <gtest/gtest.h>

#include <map>
#include <vector>

#include "engine/hybrid/hole_rings.h"
#include "tests/hole_shapes.h"

namespace stream_recon {
namespace {

using Rings = std::vector<std::vector<std::uint32_t>>;

Hole flat(std::vector<HoleTriangle> fills) {
  Hole hole;
  hole.fills = std::move(fills);
  for (const HoleTriangle& t : hole.fills) {
    for (const std::uint32_t v : t) {
      while (hole.points.size() <= v) {
        hole.points.push_back({static_cast<double>(hole.points.size()), 0, 0});
      }
    }
  }
  return hole;
}

/// How often the rings go up each edge less how often down.
std::map<HoleEdge, int> turns(const Rings& rings) {
  std::map<HoleEdge, int> sums;
  for (const auto& ring : rings) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const std::uint32_t a = ring[i], b = ring[(i + 1) % ring.size()];
      sums[{std::min(a, b), std::max(a, b)}] += a < b ? 1 : -1;
    }
  }
  return sums;
}

TEST(HoleRings, OneTriangleIsItsOwnRing) {
  EXPECT_EQ(hole_rings(flat({{2, 0, 1}})), (Rings{{0, 1, 2}}));
}

TEST(HoleRings, FillsThatTouchAtAVertexHaveTheirOwnRings) {
  EXPECT_EQ(hole_rings(flat({{0, 1, 2}, {0, 3, 4}})), (Rings{{0, 1, 2}, {0, 3, 4}}));
}

TEST(HoleRings, ARingPassesAPinchTwiceWithoutCrossing) {
  // Around 0 the fans (0 1 2) and (0 3 4), joined beyond: from 4 the ring comes to 0 along the
  // second fan and goes on with it, to 3.
  const Hole hole = flat({{0, 1, 2}, {0, 3, 4}, {2, 5, 3}, {1, 5, 2}, {3, 5, 4}});
  EXPECT_EQ(hole_rings(hole), (Rings{{0, 1, 5, 4, 0, 3, 2}}));
}

TEST(HoleRings, AnAnnulusHasTwo) {
  const Hole hole = flat({{0, 3, 4}, {0, 4, 1}, {1, 4, 5}, {1, 5, 2}, {2, 5, 3}, {2, 3, 0}});
  EXPECT_EQ(hole_rings(hole), (Rings{{0, 2, 1}, {3, 4, 5}}));
}

TEST(HoleRings, AClosedSurfaceHasNone) {
  EXPECT_TRUE(hole_rings(flat({{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}})).empty());
}

TEST(HoleRings, AnEdgeOfFourFillsIsNoBorder) {
  const Hole hole = flat({{0, 1, 2}, {1, 0, 3}, {0, 1, 4}, {1, 0, 5}});
  const auto sums = turns(hole_rings(hole));
  EXPECT_FALSE(sums.contains({0, 1}));
  EXPECT_EQ(sums, shapes::boundary(hole.fills));
}

TEST(HoleRings, EveryBorderEdgeIsInOneRingOfRandomPieces) {
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    shapes::Random random(seed);
    const shapes::Surface torus = shapes::torus(12, 9, 0.2, random);
    const double share = 0.2 + 0.6 * static_cast<double>(seed % 7) / 7;
    const Hole hole = shapes::hole(torus, [&](const Point3&) {
      return std::uniform_real_distribution<double>(0, 1)(random) < share;
    });
    const Rings rings = hole_rings(hole);
    EXPECT_EQ(turns(rings), shapes::boundary(hole.fills));
    std::size_t edges = 0;
    for (const auto& ring : rings) edges += ring.size();
    EXPECT_EQ(edges, shapes::boundary(hole.fills).size());
  }
}

}  // namespace
}  // namespace stream_recon
