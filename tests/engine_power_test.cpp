// Windows of the power diagram of a cloud's poles: the stars of the whole diagram, however the
// cloud is cut and whatever the labels.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <memory>
#include <ostream>
#include <random>
#include <set>
#include <string>
#include <vector>

#include "engine/power/power_window.h"
#include "engine/windows/certified_window.h"
#include "engine/windows/index_reader.h"
#include "spatial/regular_triangulation.h"
#include "tests/point_families.h"
#include "tests/pole_clouds.h"

namespace stream_recon {
namespace {

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr std::size_t kShare = 5;  // of the points: each takes ten times as long
#else
constexpr std::size_t kShare = 1;
#endif

constexpr std::uint64_t kMemory = std::uint64_t{2} << 30;
constexpr std::uint64_t kInfinitePole = ~std::uint64_t{0};

/// Numbers of the poles of a cell, ascending; infinity last.
using PoleCell = std::array<std::uint64_t, 4>;

using Cloud = std::vector<Point3>;

Point3 direction(std::mt19937_64& random) {
  for (;;) {
    const Point3 p = families::random_point(random);
    const double size = length(p);
    if (size > 0.01 && size <= 1) return scaled(p, 1 / size);
  }
}

Cloud blob(std::size_t count, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  Cloud cloud;
  for (std::size_t i = 0; i < count; ++i) {
    const Point3 d = direction(random);
    cloud.push_back(scaled(d, 1 + 0.2 * std::sin(4 * d.x) * std::cos(3 * d.y + d.z)));
  }
  return cloud;
}

bool is_in_blob(const Point3& p) {
  const double size = length(p);
  if (size == 0) return true;
  const Point3 d = scaled(p, 1 / size);
  return size < 1 + 0.2 * std::sin(4 * d.x) * std::cos(3 * d.y + d.z);
}

Cloud torus(std::size_t count, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> angle(0, 6.283185307179586);
  Cloud cloud;
  for (std::size_t i = 0; i < count; ++i) {
    const double a = angle(random);
    const double b = angle(random);
    const double ring = 1 + 0.35 * std::cos(b);
    cloud.push_back({ring * std::cos(a), ring * std::sin(a), 0.35 * std::sin(b)});
  }
  return cloud;
}

bool is_in_torus(const Point3& p) {
  const double ring = std::sqrt(p.x * p.x + p.y * p.y) - 1;
  return ring * ring + p.z * p.z < 0.35 * 0.35;
}

/// Boundary voxels of a ball: cospherical and coplanar samples everywhere.
Cloud voxel_shell(double radius) {
  const auto contains = [radius](int x, int y, int z) {
    return x * x + y * y + 9 * z * z < radius * radius;
  };
  Cloud cloud;
  const int n = static_cast<int>(radius) + 1;
  for (int z = -n; z <= n; ++z) {
    for (int y = -n; y <= n; ++y) {
      for (int x = -n; x <= n; ++x) {
        const bool is_inner = contains(x + 1, y, z) && contains(x - 1, y, z) &&
                              contains(x, y + 1, z) && contains(x, y - 1, z) &&
                              contains(x, y, z + 1) && contains(x, y, z - 1);
        if (contains(x, y, z) && !is_inner) cloud.push_back({1.0 * x, 1.0 * y, 3.0 * z});
      }
    }
  }
  return cloud;
}

Cloud noise(std::size_t count, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  Cloud cloud(count);
  for (Point3& p : cloud) p = families::random_point(random);
  return cloud;
}

PoleCloud::IsInside random_labels() {
  auto random = std::make_shared<std::mt19937_64>(11);
  return [random](const Point3&) { return (*random)() % 2 != 0; };
}

/// Of the power diagram of all poles, in core, and of those only with a pole inside.
std::set<PoleCell> cells_of_all(const PoleCloud& cloud, const PoleIndex& poles) {
  RegularTriangulation whole({.range = poles.range()});
  std::vector<WeightedPoint3> sites;
  for (const Pole& pole : cloud.poles) sites.push_back(site_of(pole));
  EXPECT_EQ(whole.insert(sites), RegularTriangulation::Outcome::kDone);
  std::set<PoleCell> cells;
  const WeightedCellView view = whole.view();
  for (CellId c = 0; c < view.slots(); ++c) {
    if (!view.is_live(c)) continue;
    PoleCell cell;
    bool has_inner = false;
    for (int i = 0; i < 4; ++i) {
      const VertexId v = view.vertex(c, i);
      cell[i] = v == RegularTriangulation::kInfinite ? kInfinitePole : v;
      has_inner |= v != RegularTriangulation::kInfinite && cloud.poles[v].is_inside != 0;
    }
    std::sort(cell.begin(), cell.end());
    if (has_inner) cells.insert(cell);
  }
  return cells;
}

bool is_owned(const PoleCloud& cloud, std::uint64_t number, const OwnedRange& owned) {
  if (number == kInfinitePole || cloud.poles[number].is_inside == 0) return false;
  const std::uint32_t rank = cloud.poles[number].lowest_rank();
  return rank >= owned.first && rank < owned.end();
}

bool has_owned(const PoleCloud& cloud, const PoleCell& cell, const OwnedRange& owned) {
  return std::any_of(cell.begin(), cell.end(),
                     [&](std::uint64_t number) { return is_owned(cloud, number, owned); });
}

struct Windows {
  explicit Windows(const PoleCloud& made)
      : cloud(made),
        poles(cloud.stage.scratch, 3),
        finder(poles),
        caches(cloud.stage.scratch, cloud.index, std::uint64_t{16} << 20),
        reader(caches),
        samples(cloud.index, reader, cloud.stage.context, {.whole_stars = true}) {}

  /// Of the window, those with an owned pole.
  std::set<PoleCell> cells(const OwnedRange& owned) {
    EXPECT_EQ(samples.build(owned, kMemory), CertifiedWindow::Outcome::kDone);
    PowerWindow power(samples, poles, finder);
    EXPECT_EQ(power.build(owned, kMemory), CertifiedWindow::Outcome::kDone);
    const WeightedCellView view = power.triangulation().view();
    std::set<PoleCell> found;
    std::set<std::uint64_t> numbers;
    for (CellId c = 0; c < view.slots(); ++c) {
      if (!view.is_live(c)) continue;
      PoleCell cell;
      for (int i = 0; i < 4; ++i) {
        const VertexId v = view.vertex(c, i);
        const bool is_infinite = v == RegularTriangulation::kInfinite;
        cell[i] = is_infinite ? kInfinitePole : power.poles()[v].number;
      }
      std::sort(cell.begin(), cell.end());
      if (has_owned(cloud, cell, owned)) found.insert(cell);
    }
    for (VertexId v = 0; v < power.poles().count(); ++v) {
      EXPECT_TRUE(numbers.insert(power.poles()[v].number).second) << "a pole is there twice";
      EXPECT_EQ(v < power.poles().owned_count(), is_owned(cloud, power.poles()[v].number, owned));
    }
    owned_poles += power.counts().owned;
    samples.clear();
    return found;
  }

  const PoleCloud& cloud;
  PoleIndex poles;
  PoleFinder finder;
  IndexCaches caches;
  IndexReader reader;
  CertifiedWindow samples;
  std::uint64_t owned_poles = 0;
};

struct Case {
  std::string name;
  std::function<Cloud()> make;
  std::function<PoleCloud::IsInside()> labels;
};

void PrintTo(const Case& of, std::ostream* out) {
  *out << of.name;
}

class Power : public testing::TestWithParam<Case> {};

TEST_P(Power, WindowsOfAnySizeHaveTheStarsOfTheWholeDiagramsInnerPoles) {
  const PoleCloud cloud(GetParam().make(), GetParam().labels());
  Windows windows(cloud);
  const std::set<PoleCell> whole = cells_of_all(cloud, windows.poles);
  const std::uint64_t count = cloud.points.size();
  ASSERT_GT(whole.size(), count) << "there is nothing to be found";
  for (const std::uint64_t size : {count, count / 3 / 16 * 16, std::uint64_t{208}}) {
    windows.owned_poles = 0;
    for (std::uint64_t first = 0, number = 0; first < count; first += size, ++number) {
      if (size == 208 && number % 4 != 1) continue;
      const OwnedRange owned{first, std::min(size, count - first)};
      std::set<PoleCell> expected;
      for (const PoleCell& cell : whole) {
        if (has_owned(cloud, cell, owned)) expected.insert(cell);
      }
      const std::set<PoleCell> found = windows.cells(owned);
      EXPECT_TRUE(found == expected) << size << " samples from " << first << ": " << found.size()
                                     << " cells for " << expected.size();
    }
    const auto inner = std::count_if(cloud.poles.begin(), cloud.poles.end(),
                                     [](const Pole& pole) { return pole.is_inside != 0; });
    if (size != 208) {
      EXPECT_EQ(windows.owned_poles, static_cast<std::uint64_t>(inner));
    }
  }
}

PoleCloud::IsInside all_inside() {
  return [](const Point3&) { return true; };
}

INSTANTIATE_TEST_SUITE_P(
    Clouds, Power,
    testing::Values(
        Case{"blob", [] { return blob(3000 / kShare, 1); },
             [] { return PoleCloud::IsInside(is_in_blob); }},
        Case{"torus", [] { return torus(1500 / kShare, 2); },
             [] { return PoleCloud::IsInside(is_in_torus); }},
        Case{"blob_with_random_labels", [] { return blob(1500 / kShare, 3); }, random_labels},
        Case{"blob_all_of_it_inside", [] { return blob(1000 / kShare, 4); }, all_inside},
        Case{"voxel_shell", [] { return voxel_shell(kShare == 1 ? 15 : 7); },
             [] { return PoleCloud::IsInside([](const Point3& p) { return length(p) < 12; }); }},
        Case{"voxel_shell_with_random_labels", [] { return voxel_shell(kShare == 1 ? 11 : 6); },
             random_labels},
        Case{"noise", [] { return noise(1500 / kShare, 5); },
             [] { return PoleCloud::IsInside([](const Point3& p) { return length(p) < 0.9; }); }},
        Case{"noise_with_random_labels", [] { return noise(1000 / kShare, 6); }, random_labels}),
    [](const auto& test) { return test.param.name; });

CellRanks ranks_of(const FinalWindow& window, CellId cell) {
  CellRanks ranks;
  for (int i = 0; i < 4; ++i) {
    const VertexId v = window.delaunay().vertices(cell)[i];
    ranks[i] = v == Delaunay::kInfinite ? kInfiniteRank : window.rank(v);
  }
  std::sort(ranks.begin(), ranks.end());
  return ranks;
}

TEST(CertifiedWindowProve, CallsOnlyCellsOfTheWholeCloudFinalAndKeepsThem) {
  for (const Cloud& points : {blob(3000 / kShare, 7), voxel_shell(kShare == 1 ? 15 : 7)}) {
    const PoleCloud cloud(points, all_inside());
    const std::set<CellRanks> whole = cloud.cells();
    Windows windows(cloud);
    CertifiedWindow& window = windows.samples;
    const std::uint64_t middle = cloud.points.size() / 3 / 16 * 16;
    ASSERT_EQ(window.build({middle, std::min<std::uint64_t>(middle, 160)}, kMemory),
              CertifiedWindow::Outcome::kDone);
    std::set<CellRanks> final_before;
    for (int round = 0; round < 6; ++round) {
      const Delaunay& delaunay = window.view().delaunay();
      std::set<CellRanks> final_now;
      std::vector<CellId> open;
      for (CellId c = 0; c < delaunay.cell_slots(); ++c) {
        if (!delaunay.is_live(c)) {
          EXPECT_FALSE(window.is_final(c));
        } else if (window.is_final(c)) {
          final_now.insert(ranks_of(window.view(), c));
        } else if (open.size() < 300) {
          open.push_back(c);
        }
      }
      EXPECT_TRUE(std::includes(whole.begin(), whole.end(), final_now.begin(), final_now.end()))
          << "round " << round;
      EXPECT_TRUE(std::includes(final_now.begin(), final_now.end(), final_before.begin(),
                                final_before.end()))
          << "round " << round << ": what was final is gone";
      if (round > 0 && !open.empty()) {
        EXPECT_GT(final_now.size(), final_before.size());
      }
      final_before = final_now;
      ASSERT_EQ(window.prove(open, kMemory), CertifiedWindow::Outcome::kDone);
      EXPECT_TRUE(open.empty());
    }
    window.clear();
  }
}

/// Names with many of one lowest rank, over several blocks of the store.
std::vector<NodeKey> random_names(std::size_t count) {
  std::mt19937_64 random(9);
  std::set<NodeKey> names;
  while (names.size() < count) {
    const auto lowest = static_cast<std::uint32_t>(random() % 40 * 3);
    const auto above = [&] { return lowest + 1 + static_cast<std::uint32_t>(random() % 5000); };
    NodeKey name{{lowest, above(), above(), above()}};
    std::sort(name.ranks.begin(), name.ranks.end());
    names.insert(name);
  }
  return {names.begin(), names.end()};
}

class Finder : public testing::TestWithParam<std::uint64_t> {};

TEST_P(Finder, FindsEveryNameAndNoOtherAcrossBlocks) {
  StageFixture stage;
  const std::size_t a_block = kPoleStoreBlock / sizeof(Pole);
  const std::vector<NodeKey> names = random_names(3 * a_block + 17);
  {
    auto store = create_records<Pole>(stage.scratch, kPoleStore, kPoleStoreBlock);
    for (std::size_t i = 0; i < names.size(); ++i) {
      Pole pole;
      pole.tetrahedron = names[i];
      pole.centre = {static_cast<double>(i), 0, -3};
      pole.radius = 2;
      store.append(pole);
    }
    store.finish();
  }
  const PoleIndex index(stage.scratch, GetParam());
  PoleFinder finder(index);
  ASSERT_EQ(finder.count(), names.size());
  EXPECT_EQ(index.reach(), static_cast<double>(names.size() - 1));
  std::mt19937_64 random(10);
  for (std::size_t k = 0; k < names.size(); ++k) {
    const std::size_t i = k % 2 == 0 ? k : random() % names.size();
    ASSERT_EQ(finder.find(names[i]), i);
    ASSERT_EQ(finder.pole(static_cast<PoleNumber>(i)).centre.x, static_cast<double>(i));
    NodeKey other = names[i];
    ++other.ranks[3];
    const bool is_there = std::binary_search(names.begin(), names.end(), other);
    ASSERT_EQ(finder.find(other) != kNoPole, is_there);
  }
  EXPECT_EQ(finder.find({{0, 0, 0, 0}}), kNoPole);
  EXPECT_EQ(finder.find(kInfiniteNode), kNoPole);
  for (std::uint32_t rank = 0; rank < 130; ++rank) {
    const auto at = std::lower_bound(names.begin(), names.end(), NodeKey{{rank, 0, 0, 0}});
    EXPECT_EQ(finder.lower_bound(rank), at - names.begin());
  }
  EXPECT_EQ(finder.lower_bound(0xffffffff), names.size());
}

INSTANTIATE_TEST_SUITE_P(Pages, Finder, testing::Values(1, 2, 100));

TEST(FinderOfNoPoles, FindsNone) {
  StageFixture stage;
  create_records<Pole>(stage.scratch, kPoleStore, kPoleStoreBlock).finish();
  const PoleIndex index(stage.scratch, 1);
  PoleFinder finder(index);
  EXPECT_EQ(finder.count(), 0U);
  EXPECT_EQ(finder.find({{0, 1, 2, 3}}), kNoPole);
  EXPECT_EQ(finder.lower_bound(0), 0U);
}

}  // namespace
}  // namespace stream_recon
