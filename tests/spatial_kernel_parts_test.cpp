// The parts of the Delaunay kernel, each by itself.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <vector>

#include "spatial/coordinate_range.h"
#include "spatial/delaunay.h"
#include "spatial/growable_array.h"
#include "spatial/insertion_rounds.h"
#include "spatial/predicates.h"
#include "spatial/sphere_batch.h"

namespace stream_recon {
namespace {

using detail::Cell;

TEST(GrowableArray, KeepsItsElementsAndReadsZeroBeyond) {
  GrowableArray<std::uint32_t> array;
  array.reserve(3);
  for (std::uint32_t i = 0; i < 3; ++i) array[i] = i + 1;
  array.reserve(5'000'000);
  EXPECT_EQ(array[0] + array[1] + array[2], 6U);
  EXPECT_EQ(array[4'999'999], 0U);
  GrowableArray<std::uint32_t> moved = std::move(array);
  EXPECT_EQ(moved[2], 3U);
}

TEST(InsertionRounds, EveryPositionHasOneRoundAndRoundsGrowEightfold) {
  constexpr std::size_t kCount = 1 << 20;
  const detail::InsertionRounds rounds(kCount);
  std::vector<std::size_t> sizes(static_cast<std::size_t>(rounds.last()) + 1);
  for (std::size_t i = 0; i < kCount; ++i) ++sizes.at(rounds.round_of(i));
  ASSERT_GE(sizes.size(), 4U);
  for (std::size_t r = 0; r + 1 < sizes.size(); ++r) {
    std::size_t before = 0;
    for (std::size_t k = r + 1; k < sizes.size(); ++k) before += sizes[k];
    EXPECT_NEAR(static_cast<double>(sizes[r]) / static_cast<double>(before), 7, 2) << "round " << r;
  }
}

TEST(InsertionRounds, FewPointsAreOneRound) {
  const detail::InsertionRounds rounds(100);
  EXPECT_EQ(rounds.last(), 0);
  EXPECT_EQ(rounds.round_of(99), 0);
}

// Positively oriented cells over points of a family, with query points among them.
struct BatchCase {
  std::vector<Point3> points;
  std::vector<Cell> cells;
};

BatchCase make_cells(std::uint64_t seed, double lattice) {
  BatchCase made;
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> coordinate(-1, 1);
  const auto draw = [&] {
    const double c = coordinate(random);
    return lattice == 0 ? c : std::round(c * lattice);
  };
  for (int i = 0; i < 400; ++i) made.points.push_back({draw(), draw(), draw()});
  CoordinateRange range;
  for (const Point3& p : made.points) range.extend(p);
  const Predicates exact(range);
  std::uniform_int_distribution<std::uint32_t> vertex(1, 399);
  while (made.cells.size() < 4000) {
    Cell cell{{vertex(random), vertex(random), vertex(random), vertex(random)}, {}};
    const auto& v = cell.vertex;
    const int sign =
        exact.orient3d(made.points[v[0]], made.points[v[1]], made.points[v[2]], made.points[v[3]]);
    if (sign == 0) continue;
    if (sign < 0) std::swap(cell.vertex[0], cell.vertex[1]);
    made.cells.push_back(cell);
  }
  return made;
}

class SphereBatches : public testing::TestWithParam<double> {};

TEST_P(SphereBatches, CertainLanesAgreeWithTheExactPredicate) {
  const BatchCase made = make_cells(11, GetParam());
  CoordinateRange range;
  for (const Point3& p : made.points) range.extend(p);
  const Predicates exact(range);
  int certain = 0;
  int cospherical = 0;
  for (std::size_t i = 0; i + 4 <= made.cells.size(); i += 4) {
    const std::array<const Cell*, 4> cells{&made.cells[i], &made.cells[i + 1], &made.cells[i + 2],
                                           &made.cells[i + 3]};
    const detail::PaddedPoint query{made.points[i % 400]};
    const auto found =
        detail::test_spheres_portable(cells, made.points.data(), query, exact.in_sphere_reach());
    for (unsigned lane = 0; lane < 4; ++lane) {
      const auto& v = cells[lane]->vertex;
      const int sign = exact.in_sphere(made.points[v[0]], made.points[v[1]], made.points[v[2]],
                                       made.points[v[3]], query.point);
      const bool inside = (found.inside >> lane & 1) != 0;
      const bool outside = (found.outside >> lane & 1) != 0;
      const bool tie = (found.cospherical >> lane & 1) != 0;
      if (inside) {
        EXPECT_EQ(sign, 1);
      }
      if (outside) {
        EXPECT_EQ(sign, -1);
      }
      if (tie) {
        EXPECT_EQ(sign, 0);
      }
      certain += inside || outside || tie ? 1 : 0;
      cospherical += tie ? 1 : 0;
    }
  }
  EXPECT_GT(certain, 3900) << "the filter should settle nearly all";
  if (GetParam() != 0) {
    EXPECT_GT(cospherical, 10) << "the lattice should have ties";
  }
}

#if defined(__x86_64__)
TEST_P(SphereBatches, VectorsAndPortableCodeAgreeBitForBit) {
  if (!__builtin_cpu_supports("avx2")) GTEST_SKIP() << "this processor has no AVX2";
  const BatchCase made = make_cells(12, GetParam());
  for (const double reach : {0.0, 3.0, 1e9}) {
    for (std::size_t i = 0; i + 4 <= made.cells.size(); i += 4) {
      const std::array<const Cell*, 4> cells{&made.cells[i], &made.cells[i + 1], &made.cells[i + 2],
                                             &made.cells[i + 3]};
      const detail::PaddedPoint query{made.points[i % 399]};
      const auto a = detail::test_spheres_portable(cells, made.points.data(), query, reach);
      const auto b = detail::test_spheres_avx2(cells, made.points.data(), query, reach);
      EXPECT_EQ(a.inside, b.inside);
      EXPECT_EQ(a.outside, b.outside);
      EXPECT_EQ(a.cospherical, b.cospherical);
    }
  }
}
#endif

INSTANTIATE_TEST_SUITE_P(RandomAndLattices, SphereBatches, testing::Values(0.0, 3.0, 40.0));

// Every vertex is a corner of a cell with the hub: a boundary far beyond the small table.
TEST(StarBuilder, HubOfASphereOfThreeThousandPoints) {
  std::mt19937_64 random(5);
  std::normal_distribution<double> normal;
  std::vector<Point3> sphere;
  for (int i = 0; i < 3000; ++i) {
    const Point3 p{normal(random), normal(random), normal(random)};
    const double length = std::sqrt(p.x * p.x + p.y * p.y + p.z * p.z);
    sphere.push_back({p.x / length, p.y / length, p.z / length});
  }
  Delaunay mesh;
  ASSERT_EQ(mesh.insert(sphere), Delaunay::Outcome::kDone);
  const Point3 hub{1e-3, 2e-3, 0};
  ASSERT_EQ(mesh.insert({&hub, 1}), Delaunay::Outcome::kDone);
  std::size_t at_hub = 0;
  for (CellId c = 0; c < mesh.cell_slots(); ++c) {
    if (!mesh.is_live(c)) continue;
    const auto vertices = mesh.vertices(c);
    at_hub += std::ranges::count(vertices, VertexId{3000});
    for (int i = 0; i < 4; ++i) {
      const CellId other = mesh.neighbor(c, i);
      EXPECT_TRUE(mesh.is_live(other));
      EXPECT_EQ(mesh.neighbor(other, mesh.mirror_index(c, i)), c);
    }
  }
  EXPECT_GT(at_hub, 5000U);
}

TEST(Delaunay, StopsAtItsMemoryLimit) {
  std::mt19937_64 random(6);
  std::uniform_real_distribution<double> coordinate(0, 1);
  std::vector<Point3> cube;
  for (int i = 0; i < 20000; ++i) {
    cube.push_back({coordinate(random), coordinate(random), coordinate(random)});
  }
  Delaunay unlimited;
  ASSERT_EQ(unlimited.insert(cube), Delaunay::Outcome::kDone);
  Delaunay::Options options;
  options.max_bytes = unlimited.bytes() / 2;
  Delaunay limited(options);
  EXPECT_EQ(limited.insert(cube), Delaunay::Outcome::kOutgrown);
  EXPECT_LE(limited.bytes(), options.max_bytes);
  options.max_bytes = unlimited.bytes() * 5 / 4;
  Delaunay roomy(options);
  EXPECT_EQ(roomy.insert(cube), Delaunay::Outcome::kDone);
}

}  // namespace
}  // namespace stream_recon
