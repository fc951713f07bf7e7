// The consumers of windows: against a plain loop over all facets, and from two threads at once.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <random>
#include <thread>
#include <tuple>
#include <vector>

#include "engine/alpha/alpha_filter.h"
#include "engine/gamma/gamma_filter.h"
#include "engine/windows/final_simplices.h"
#include "engine/windows/tetrahedra_census.h"
#include "tests/engine_fixture.h"
#include "tests/point_families.h"

namespace stream_recon {
namespace {

constexpr std::uint64_t kPoints = 900;
constexpr ChunkLayout kLayout{200, kPoints};

/// A window that holds all points of the cloud and owns those from `first` to `last`.
struct TestWindow {
  TestWindow(const std::vector<Point3>& cloud, PointRank first, PointRank last)
      : first_rank(first), owned(last - first) {
    for (PointRank rank = first; rank < last; ++rank) add(cloud, rank);
    for (PointRank rank = 0; rank < cloud.size(); ++rank) {
      if (rank >= first && rank < last) continue;
      add(cloud, rank);
      guests.push_back(rank);
    }
    EXPECT_EQ(delaunay.insert(points), Delaunay::Outcome::kDone);
  }

  void add(const std::vector<Point3>& cloud, PointRank rank) {
    points.push_back(cloud[rank]);
    indices.push_back(10 * rank);
  }

  FinalWindow view() const { return FinalWindow({&delaunay, first_rank, owned, guests, indices}); }

  PointRank first_rank;
  std::uint64_t owned;
  std::vector<Point3> points;
  std::vector<PointRank> guests;
  std::vector<std::uint64_t> indices;
  Delaunay delaunay;
};

/// Points of a lattice, most on it exactly, and of a ball: hull, ties and slivers.
std::vector<Point3> make_cloud(std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::vector<Point3> cloud;
  for (std::uint64_t i = 0; i < kPoints; ++i) {
    const Point3 p = families::lattice_point(random, 6, 0.25);
    if (i % 3 == 0) cloud.push_back(families::random_point(random));
    if (i % 3 == 1) cloud.push_back(families::nudged(p, random));
    if (i % 3 == 2) cloud.push_back(p);
  }
  std::sort(cloud.begin(), cloud.end());
  cloud.erase(std::unique(cloud.begin(), cloud.end()), cloud.end());
  std::shuffle(cloud.begin(), cloud.end(), random);
  return cloud;
}

using Key = std::tuple<std::array<PointRank, 3>, float, Facing>;

std::vector<Key> sorted_keys(const std::vector<FacetRecord>& records) {
  std::vector<Key> keys;
  for (const FacetRecord& r : records) keys.emplace_back(r.ranks, r.delta, r.facing);
  std::sort(keys.begin(), keys.end());
  return keys;
}

/// Every facet asked of the accurate balls, one by one.
template <class Criterion>
std::vector<Key> by_plain_loop(const FinalWindow& window, const Criterion& criterion) {
  std::vector<FacetRecord> records;
  const CellView cells = window.delaunay().view();
  for_each_final_facet(window, {0, cells.slots()}, [&](CellId cell, int side) {
    auto v = cells.facet(cell, side);
    const auto given = v;
    std::sort(v.begin(), v.end(),
              [&](VertexId a, VertexId b) { return window.rank(a) < window.rank(b); });
    const std::array<Point3, 3> corners{cells.point(v[0]), cells.point(v[1]), cells.point(v[2])};
    const Point3 apex = cells.point(cells.vertex(cell, side));
    const CellId beyond = cells.neighbor(cell, side);
    const bool hull = cells.is_infinite(beyond);
    const FacetBalls balls =
        hull ? hull_facet_balls(corners, apex)
             : facet_balls(corners, apex,
                           cells.point(cells.vertex(beyond, cells.mirror_index(cell, side))));
    if (!criterion.takes(balls)) return;
    FacetRecord record{{window.rank(v[0]), window.rank(v[1]), window.rank(v[2])},
                       static_cast<float>(gamma_angle(balls)),
                       {}};
    const int first = static_cast<int>(std::find(given.begin(), given.end(), v[0]) - given.begin());
    const bool even = given[(first + 1) % 3] == v[1];
    if (hull) record.facing = even ? Facing::kOutward : Facing::kInward;
    records.push_back(record);
  });
  return sorted_keys(records);
}

std::vector<Key> all_keys(const ExportedFacets& facets) {
  std::vector<FacetRecord> all;
  for (std::uint64_t chunk = 0; chunk < kLayout.chunk_count(); ++chunk) {
    const auto records = facets.facets().records(chunk);
    all.insert(all.end(), records.begin(), records.end());
  }
  return sorted_keys(all);
}

/// One thread a window.
void consume_all(const std::vector<TestWindow>& windows, WindowConsumer& consumer,
                 ScratchDirectory& scratch) {
  std::vector<std::thread> threads;
  for (const TestWindow& window : windows) {
    threads.emplace_back([&] {
      ExportWriter out(scratch, window.view().rank(0));
      consumer.consume(window.view(), out);
      out.finish();
    });
  }
  for (std::thread& thread : threads) thread.join();
}

std::vector<TestWindow> cut(const std::vector<Point3>& cloud) {
  std::vector<TestWindow> windows;
  const PointRank n = cloud.size();
  windows.emplace_back(cloud, 0, n / 3);
  windows.emplace_back(cloud, n / 3, n / 2);
  windows.emplace_back(cloud, n / 2, n);
  return windows;
}

template <class Filter, class Criterion>
void compare_with_plain_loop(double threshold) {
  constexpr std::uint64_t kSeed = 21;
  const std::vector<Point3> cloud = make_cloud(kSeed);
  const TestWindow whole(cloud, 0, cloud.size());
  const auto expected = by_plain_loop(whole.view(), Criterion(threshold));
  const auto found_in = [&](const std::vector<TestWindow>& windows) {
    StageFixture stage;
    Filter filter(threshold, kLayout, stage.stop);
    consume_all(windows, filter, stage.scratch);
    const ExportReader exports(stage.scratch, stage.budget);
    return all_keys({exports, kLayout});
  };
  std::vector<TestWindow> one;
  one.emplace_back(cloud, 0, cloud.size());
  EXPECT_EQ(found_in(one), expected) << threshold << ", seed " << kSeed;
  EXPECT_EQ(found_in(cut(cloud)), expected) << threshold << ", seed " << kSeed;
}

TEST(FacetFilter, TakesTheGammaFacetsOfAPlainLoopFromManyWindowsAtOnce) {
  for (const double delta_max : {20.0, 90.0, 135.0, 180.0}) {
    compare_with_plain_loop<GammaFilter, GammaCriterion>(delta_max);
  }
}

TEST(FacetFilter, TakesTheAlphaFacetsOfAPlainLoopFromManyWindowsAtOnce) {
  for (const double alpha : {0.05, 0.125, 0.2, 10.0}) {
    compare_with_plain_loop<AlphaFilter, AlphaCriterion>(alpha);
  }
}

TEST(FacetFilter, StopsOnRequest) {
  const std::vector<Point3> cloud = make_cloud(22);
  const TestWindow window(cloud, 0, cloud.size());
  StageFixture stage;
  GammaFilter filter(90, kLayout, stage.stop);
  ExportWriter out(stage.scratch, 0);
  stage.stop.request();
  EXPECT_THROW(filter.consume(window.view(), out), Interrupted);
}

TEST(TetrahedraCensus, AddsUpOverWindows) {
  const std::vector<Point3> cloud = make_cloud(23);
  const TestWindow whole(cloud, 0, cloud.size());
  const TetrahedraCensus expected = take_census(whole.view());
  EXPECT_EQ(expected.count, whole.delaunay.finite_cell_count());
  TetrahedraCensus census;
  for (const TestWindow& window : cut(cloud)) census.merge(take_census(window.view()));
  EXPECT_EQ(census.count, expected.count);
  EXPECT_EQ(census.digest.hex(), expected.digest.hex());
}

}  // namespace
}  // namespace stream_recon
