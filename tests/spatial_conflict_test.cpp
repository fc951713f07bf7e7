// Conflicts of a point with cells against what its insertion destroys.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "spatial/delaunay.h"
#include "tests/point_families.h"

namespace stream_recon {
namespace {

using Corners = std::array<VertexId, 4>;

Corners sorted_vertices(const Delaunay& delaunay, CellId c) {
  Corners corners = delaunay.vertices(c);
  std::sort(corners.begin(), corners.end());
  return corners;
}

/// Infinite ones too: with kInfinite for a corner.
std::set<Corners> cells(const Delaunay& delaunay) {
  std::set<Corners> all;
  for (CellId c = 0; c < delaunay.cell_slots(); ++c) {
    if (delaunay.is_live(c)) all.insert(sorted_vertices(delaunay, c));
  }
  return all;
}

/// Inserts all but the last of the points, and says which conflicts its insertion contradicts.
void expect_conflicts_as_inserted(const std::vector<Point3>& points) {
  Delaunay::Options options;
  for (const Point3& p : points) options.range.extend(p);
  Delaunay before(options);
  const std::span<const Point3> old(points.data(), points.size() - 1);
  if (before.insert(old) != Delaunay::Outcome::kDone) return;
  Delaunay after(options);
  ASSERT_EQ(after.insert(old), Delaunay::Outcome::kDone);
  ASSERT_EQ(cells(after), cells(before));
  ASSERT_EQ(after.insert({&points.back(), 1}), Delaunay::Outcome::kDone);
  const std::set<Corners> left = cells(after);
  std::size_t conflicts = 0;
  for (CellId c = 0; c < before.cell_slots(); ++c) {
    if (!before.is_live(c)) continue;
    const bool is_gone = !left.contains(sorted_vertices(before, c));
    ASSERT_EQ(before.in_conflict(c, points.back()), is_gone)
        << "cell " << c << (before.is_infinite(c) ? ", infinite" : "");
    conflicts += is_gone;
  }
  ASSERT_GT(conflicts, 0u);
}

/// Distinct ones in random order.
std::vector<Point3> draw(const families::Family& family, std::size_t count, double scale,
                         std::mt19937_64& random) {
  std::set<Point3> distinct;
  for (std::size_t i = 0; i < count; ++i) {
    const Point3 p = family.draw(random);
    distinct.insert({p.x * scale, p.y * scale, p.z * scale});
  }
  std::vector<Point3> points(distinct.begin(), distinct.end());
  std::shuffle(points.begin(), points.end(), random);
  return points;
}

TEST(DelaunayConflict, CellsInConflictAreThoseThatInsertionDestroys) {
  for (const families::Family& family : families::all()) {
    for (unsigned seed = 0; seed < 15; ++seed) {
      SCOPED_TRACE(family.name + ", seed " + std::to_string(seed));
      std::mt19937_64 random(seed);
      const std::size_t count = seed % 3 == 0 ? 8 : 90;
      ASSERT_NO_FATAL_FAILURE(expect_conflicts_as_inserted(draw(family, count, 1, random)));
    }
  }
}

TEST(DelaunayConflict, DoesNotChangeWithTheScale) {
  for (const double scale : {0x1p-400, 0x1p400}) {
    for (unsigned seed = 0; seed < 15; ++seed) {
      SCOPED_TRACE(std::to_string(std::ilogb(scale)) + ", seed " + std::to_string(seed));
      std::mt19937_64 random(seed);
      const families::Family& family = families::all()[seed % 2];
      ASSERT_NO_FATAL_FAILURE(expect_conflicts_as_inserted(draw(family, 90, scale, random)));
    }
  }
}

}  // namespace
}  // namespace stream_recon
