#include "spatial/hilbert.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <map>
#include <random>
#include <set>

namespace stream_recon {
namespace {

constexpr int kCells = 16;
constexpr int kCellLevels = 4;

struct Cell {
  int x;
  int y;
  int z;
};

// All cells of a coarse grid by their key on that level, from points inside the cells.
std::map<std::uint64_t, Cell> coarse_curve() {
  const HilbertCurve curve(Box3{{0, 0, 0}, {kCells, kCells, kCells}});
  std::map<std::uint64_t, Cell> cells;
  for (int x = 0; x < kCells; ++x) {
    for (int y = 0; y < kCells; ++y) {
      for (int z = 0; z < kCells; ++z) {
        const std::uint64_t key = curve.key({x + 0.3, y + 0.6, z + 0.1});
        cells[key >> (3 * (HilbertCurve::kBits - kCellLevels))] = {x, y, z};
      }
    }
  }
  return cells;
}

TEST(HilbertCurve, visits_every_cell_of_a_grid_once) {
  const auto cells = coarse_curve();
  EXPECT_EQ(cells.size(), kCells * kCells * kCells);
  EXPECT_EQ(cells.rbegin()->first, cells.size() - 1);
}

TEST(HilbertCurve, neighbours_on_the_curve_share_a_face) {
  const auto cells = coarse_curve();
  for (auto next = std::next(cells.begin()); next != cells.end(); ++next) {
    const Cell& a = std::prev(next)->second;
    const Cell& b = next->second;
    EXPECT_EQ(std::abs(a.x - b.x) + std::abs(a.y - b.y) + std::abs(a.z - b.z), 1) << next->first;
  }
}

TEST(HilbertCurve, neighbours_on_the_finest_grid_share_a_face) {
  constexpr int kSide = 1 << HilbertCurve::kBits;
  const HilbertCurve curve(Box3{{0, 0, 0}, {kSide, kSide, kSide}});
  constexpr int kBase = 123456;
  std::map<std::uint64_t, Cell> cells;
  for (int i = 0; i < 16 * 16 * 16; ++i) {
    const Cell cell{i % 16, i / 16 % 16, i / 256};
    cells[curve.key({kBase + cell.x + 0.5, kBase + cell.y + 0.5, kBase + cell.z + 0.5})] = cell;
  }
  ASSERT_EQ(cells.size(), 16 * 16 * 16);
  for (auto next = std::next(cells.begin()); next != cells.end(); ++next) {
    const auto before = std::prev(next);
    if (next->first != before->first + 1) continue;
    const Cell& a = before->second;
    const Cell& b = next->second;
    EXPECT_EQ(std::abs(a.x - b.x) + std::abs(a.y - b.y) + std::abs(a.z - b.z), 1);
  }
}

TEST(HilbertCurve, an_octree_node_is_a_key_range_at_every_depth) {
  const std::uint64_t seed = 7;
  SCOPED_TRACE(seed);
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> uniform(0, 1);
  const HilbertCurve curve(Box3{{0, 0, 0}, {1, 1, 1}});
  for (int round = 0; round < 20000; ++round) {
    const int depth = 1 + static_cast<int>(random() % HilbertCurve::kBits);
    const double cells = std::ldexp(1.0, depth);
    const Point3 p{uniform(random), uniform(random), uniform(random)};
    const auto within = [&](double c) { return (std::floor(c * cells) + uniform(random)) / cells; };
    const Point3 q{within(p.x), within(p.y), within(p.z)};
    const int shift = 3 * (HilbertCurve::kBits - depth);
    EXPECT_EQ(curve.key(p) >> shift, curve.key(q) >> shift);
    const Point3 other{p.x < 0.5 ? p.x + 0.5 : p.x - 0.5, p.y, p.z};
    EXPECT_NE(curve.key(p) >> shift, curve.key(other) >> shift);
  }
}

TEST(HilbertCurve, corners_of_the_box_and_points_outside_have_keys_in_range) {
  const HilbertCurve curve(Box3{{-1, -1, -1}, {1, 1, 1}});
  EXPECT_EQ(curve.key({-1, -1, -1}), 0U);
  for (const double x : {-1e300, -1.0, 1.0, 1e300}) {
    EXPECT_LT(curve.key({x, x, 1}), std::uint64_t{1} << 63);
  }
  EXPECT_EQ(curve.key({1, 1, 1}), curve.key({5, 6, 7}));
}

TEST(HilbertCurve, flat_and_empty_boxes_give_keys) {
  EXPECT_EQ(HilbertCurve(Box3{{3, 3, 3}, {3, 3, 3}}).key({3, 3, 3}), 0U);
  EXPECT_EQ(HilbertCurve(Box3()).key({3, -3, 3}), 0U);
  const HilbertCurve line(Box3{{0, 3, 3}, {8, 3, 3}});
  std::set<std::uint64_t> keys;
  for (int i = 0; i < 8; ++i) keys.insert(line.key({i + 0.5, 3, 3}));
  EXPECT_EQ(keys.size(), 8U);
}

TEST(HilbertCurve, resolves_boxes_at_the_limits_of_a_double) {
  const double top = std::numeric_limits<double>::max();
  const double tiny = 5e-324;
  for (const Box3& box :
       {Box3{{-top, -top, -top}, {top, top, top}}, Box3{{0, 0, 0}, {top, 1, 1}},
        Box3{{0, 0, 0}, {16 * tiny, 16 * tiny, 16 * tiny}}, Box3{{top / 2, 0, 0}, {top, 1, 1}}}) {
    const HilbertCurve curve(box);
    std::set<std::uint64_t> keys;
    for (int i = 0; i < 16; ++i) {
      const double x = box.low.x / 16 * (16 - i) + box.high.x / 16 * i;
      keys.insert(curve.key({x, box.low.y, box.low.z}));
    }
    EXPECT_GE(keys.size(), 15U) << box.low.x << " " << box.high.x;
  }
}

}  // namespace
}  // namespace stream_recon
