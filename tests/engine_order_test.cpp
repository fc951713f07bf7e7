// The external Hilbert sort: the same store for every budget, duplicates merged, nothing lost.

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <map>
#include <random>
#include <string>
#include <tuple>
#include <vector>

#include "engine/order/hilbert_sort.h"
#include "engine/order/ingest.h"
#include "engine/order/point_store.h"
#include "engine/scratch_records.h"
#include "io/error.h"
#include "spatial/hilbert.h"
#include "tests/engine_fixture.h"

namespace stream_recon {
namespace {

constexpr std::uint64_t kMebi = std::uint64_t{1} << 20;

/// Puts `points` into the ingest spool, as ingest does.
CloudSummary spool_points(const std::vector<Point3>& points, StageFixture& stage) {
  auto writer = create_records<StoredPoint>(stage.scratch, kIngestSpool, 1 << 16);
  CloudSummary cloud;
  for (const Point3& p : points) {
    writer.append(StoredPoint{p, cloud.points++});
    cloud.box.extend(p);
  }
  writer.finish();
  return cloud;
}

std::vector<StoredPoint> read_store(const StageFixture& stage) {
  PointStoreReader reader(stage.scratch, kPointStore);
  std::vector<StoredPoint> points(reader.count());
  EXPECT_EQ(reader.read(points), points.size());
  return points;
}

std::vector<Point3> random_points(std::size_t count, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> uniform(-5, 5);
  std::vector<Point3> points(count);
  for (Point3& p : points) p = {uniform(random), uniform(random), uniform(random)};
  return points;
}

/// What the sort must give, computed in the plainest way.
std::vector<StoredPoint> sorted_plainly(const std::vector<Point3>& points, const Box3& box) {
  const HilbertCurve curve(box);
  std::vector<std::tuple<std::uint64_t, double, double, double, std::uint64_t>> rows;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Point3& p = points[i];
    rows.emplace_back(curve.key(p), p.x, p.y, p.z, i);
  }
  std::sort(rows.begin(), rows.end());
  std::vector<StoredPoint> result;
  for (const auto& [key, x, y, z, index] : rows) {
    if (result.empty() || !(result.back().point == Point3{x, y, z})) {
      result.push_back({points[index], index});
    }
  }
  return result;
}

void expect_equal(const std::vector<StoredPoint>& a, const std::vector<StoredPoint>& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    ASSERT_EQ(a[i].point, b[i].point) << i;
    ASSERT_EQ(a[i].input_index, b[i].input_index) << i;
  }
}

TEST(HilbertSort, IsTheSameForEveryBudget) {
  auto points = random_points(300'000, 1);
  const auto copies = random_points(1000, 2);
  for (int i = 0; i < 5; ++i) points.insert(points.begin() + i * 999, copies.begin(), copies.end());
  // 11 MiB: three runs, of which two can be merged at a time; 14 MiB: two runs; 1000 MiB: one.
  for (std::uint64_t memory : {11 * kMebi, 14 * kMebi, 1000 * kMebi}) {
    StageFixture stage(memory);
    const CloudSummary cloud = spool_points(points, stage);
    const OrderResult order = hilbert_sort(cloud, stage.context);
    EXPECT_EQ(order.point_count, 301'000U);
    EXPECT_EQ(order.duplicates, 4000U);
    expect_equal(read_store(stage), sorted_plainly(points, cloud.box));
    EXPECT_LE(stage.budget.peak(), memory);
    EXPECT_EQ(stage.budget.used(), 0U);
  }
}

TEST(HilbertSort, MergesNegativeZeroWithZeroUnderTheLowestIndex) {
  StageFixture stage;
  const CloudSummary cloud =
      spool_points({{1, 1, 1}, {-0.0, 0, 2}, {0.0, -0.0, 2}, {0, 0, 2}, {1, 1, 1}}, stage);
  const OrderResult order = hilbert_sort(cloud, stage.context);
  EXPECT_EQ(order.duplicates, 3U);
  for (const StoredPoint& stored : read_store(stage)) {
    EXPECT_EQ(stored.input_index, stored.point.x == 1 ? 0U : 1U);
  }
}

TEST(HilbertSort, TakesEmptyAndSinglePointClouds) {
  for (const std::vector<Point3>& points :
       {std::vector<Point3>{}, std::vector<Point3>{{1, 2, 3}}}) {
    StageFixture stage;
    const OrderResult order = hilbert_sort(spool_points(points, stage), stage.context);
    EXPECT_EQ(order.point_count, points.size());
    EXPECT_EQ(read_store(stage).size(), points.size());
  }
}

TEST(HilbertSort, RefusesABudgetThatCannotHoldItsBuffers) {
  StageFixture stage(kMebi);
  const CloudSummary cloud = spool_points(random_points(100, 3), stage);
  EXPECT_THROW((void)hilbert_sort(cloud, stage.context), BudgetError);
}

TEST(HilbertSort, StopsWhenAsked) {
  StageFixture stage;
  const CloudSummary cloud = spool_points(random_points(100, 3), stage);
  stage.stop.request();
  EXPECT_THROW((void)hilbert_sort(cloud, stage.context), Interrupted);
}

}  // namespace
}  // namespace stream_recon
