// The spacing of all points: exact neighbours, the same file whatever the memory and the threads.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "engine/order/hilbert_sort.h"
#include "engine/order/point_store.h"
#include "engine/parallel.h"
#include "engine/spacing/neighbor_search.h"
#include "engine/spacing/spacing_reader.h"
#include "engine/spacing/spacing_stage.h"
#include "spatial/local_spacing.h"
#include "tests/engine_fixture.h"
#include "tests/point_families.h"

namespace stream_recon {
namespace {

using namespace index_layout;

constexpr std::uint64_t kMebi = std::uint64_t{1} << 20;

using Cloud = std::vector<Point3>;

struct NamedCloud {
  std::string name;
  Cloud points;
};

Cloud drawn(std::size_t count, const std::string& name) {
  std::mt19937_64 random(41);
  const auto& all = families::all();
  const auto family = std::find_if(all.begin(), all.end(),
                                   [&](const auto& candidate) { return candidate.name == name; });
  Cloud cloud(count);
  for (Point3& p : cloud) p = family->draw(random);
  return cloud;
}

Cloud lattice_block(int side) {
  Cloud cloud;
  for (int i = 0; i < side * side * side; ++i) {
    cloud.push_back({0.1 * (i % side), 0.1 * (i / side % side), 0.1 * (i / side / side)});
  }
  return cloud;
}

/// Dense and sparse ones, and far outliers between them in the order of the curve.
Cloud clusters() {
  std::mt19937_64 random(42);
  Cloud cloud;
  for (int cluster = 0; cluster < 12; ++cluster) {
    const Point3 middle = families::random_point(random);
    const double size = std::pow(10.0, -cluster / 2);
    for (int i = 0; i < 250; ++i) {
      const Point3 p = families::random_point(random);
      cloud.push_back({middle.x + size * p.x, middle.y + size * p.y, middle.z + size * p.z});
    }
  }
  cloud.push_back({1000, 0, 0});
  cloud.push_back({0, -1e6, 3});
  return cloud;
}

Cloud moved(Cloud cloud, double by) {
  for (Point3& p : cloud) p = {p.x + by, p.y - by, p.z + by};
  return cloud;
}

std::vector<NamedCloud> clouds() {
  return {{"random", drawn(4500, "random")},
          {"moved", moved(drawn(3000, "random"), 1e7)},
          {"lattice", lattice_block(15)},
          {"lattice with ties everywhere", drawn(3000, "small lattice")},
          {"cospherical", drawn(2000, "cospherical")},
          {"coplanar and one",
           [] {
             Cloud cloud = drawn(2000, "coplanar");
             cloud.push_back({3, 4, 90});
             return cloud;
           }()},
          {"clusters", clusters()},
          {"many magnitudes", drawn(1000, "many magnitudes")},
          {"tiny coordinates", drawn(300, "tiny")},
          {"five points", {{0, 0, 0}, {1, 0, 0}, {0, 2, 0}, {0, 0, 3}, {1, 1, 1}}}};
}

/// A cloud as the stages before leave it.
struct IndexedCloud {
  explicit IndexedCloud(const Cloud& cloud, std::uint64_t memory = 1024 * kMebi) : stage(memory) {
    auto writer = create_records<StoredPoint>(stage.scratch, kIngestSpool, 1 << 16);
    CloudSummary summary;
    for (const Point3& p : cloud) {
      writer.append(StoredPoint{p, summary.points++});
      summary.box.extend(p);
      summary.range.extend(p);
    }
    writer.finish();
    const OrderResult order = hilbert_sort(summary, stage.context);
    index = build_index(summary, order.point_count, stage.context);
  }

  Cloud scaled_points() const {
    PointStoreReader reader(stage.scratch, kPointStore);
    std::vector<StoredPoint> stored(reader.count());
    reader.read(stored);
    Cloud points;
    const double s = index.scale;
    for (const StoredPoint& p : stored) {
      points.push_back({p.point.x * s, p.point.y * s, p.point.z * s});
    }
    return points;
  }

  std::vector<float> spacings() const {
    ScratchReader<float> reader(stage.scratch, kSpacings);
    std::vector<float> all(reader.count());
    reader.read(all);
    return all;
  }

  StageFixture stage;
  CloudIndex index;
};

/// Of every point, by looking at all others.
std::vector<Cloud> neighbors_plainly(const Cloud& points) {
  std::vector<Cloud> result;
  for (std::size_t i = 0; i < points.size(); ++i) {
    std::vector<std::pair<double, PointRank>> near;  // by squared distance, then rank
    for (std::size_t j = 0; j < points.size(); ++j) {
      const double dx = points[j].x - points[i].x;
      const double dy = points[j].y - points[i].y;
      const double dz = points[j].z - points[i].z;
      if (j != i) near.emplace_back(dx * dx + dy * dy + dz * dz, j);
    }
    const std::size_t count = std::min(near.size(), NeighborSearch::kMost);
    std::partial_sort(near.begin(), near.begin() + static_cast<std::ptrdiff_t>(count), near.end());
    Cloud& vectors = result.emplace_back();
    for (std::size_t n = 0; n < count; ++n) {
      const Point3& p = points[near[n].second];
      vectors.push_back({p.x - points[i].x, p.y - points[i].y, p.z - points[i].z});
    }
  }
  return result;
}

TEST(NeighborSearch, FindsTheNeighborsThatLookingAtAllPointsFinds) {
  for (const NamedCloud& cloud : clouds()) {
    SCOPED_TRACE(cloud.name);
    const IndexedCloud indexed(cloud.points);
    const std::vector<Cloud> expected = neighbors_plainly(indexed.scaled_points());
    IndexCaches caches(indexed.stage.scratch, indexed.index, 1);  // a page of each kind
    IndexReader reader(caches);
    NeighborSearch search(indexed.index, reader);
    // From end to end, and hither and thither, where nothing is to be guessed from the leaf before.
    const LeafNumber leaves = indexed.index.leaf_count();
    for (const LeafNumber step : {LeafNumber{1}, leaves / 2 + 1}) {
      for (LeafNumber n = 0; n < leaves; ++n) {
        const LeafNumber leaf = n * step % leaves;
        search.search(leaf);
        for (std::size_t i = 0; i < search.point_count(); ++i) {
          const auto vectors = search.vectors(i);
          const Cloud& right = expected[leaf * kLeafPoints + i];
          ASSERT_TRUE(std::equal(vectors.begin(), vectors.end(), right.begin(), right.end()))
              << "rank " << leaf * kLeafPoints + i;
        }
      }
    }
  }
}

TEST(MeasureSpacing, GivesEachPointWhatItsNeighborsSay) {
  for (const NamedCloud& cloud : clouds()) {
    SCOPED_TRACE(cloud.name);
    const IndexedCloud indexed(cloud.points);
    measure_spacing(indexed.index, std::nullopt, indexed.stage.context);
    const std::vector<Cloud> neighbors = neighbors_plainly(indexed.scaled_points());
    SpacingCache cache(indexed.stage.scratch, indexed.index, 1);
    SpacingReader reader(cache);
    ASSERT_EQ(indexed.spacings().size(), neighbors.size());
    for (std::size_t rank = neighbors.size(); rank-- > 0;) {
      const float expected = local_spacing(neighbors[rank]);
      ASSERT_GT(expected, 0);
      ASSERT_EQ(reader.at(rank), expected) << rank;
    }
  }
}

TEST(MeasureSpacing, IsTheSameForAllMemoryAndThreads) {
  std::mt19937_64 random(43);
  Cloud cloud;
  for (int i = 0; i < 120'000; ++i) {
    const Point3 p = families::random_point(random);
    cloud.push_back({p.x, p.y, 0.2 * std::sin(3 * p.x) + (i % 50 == 0 ? p.z : 0)});
  }
  std::string first;
  for (const std::uint64_t memory : {16 * kMebi, 24 * kMebi, 1024 * kMebi}) {
    for (const unsigned threads : {1U, 2U}) {
      const ThreadLimit limit(threads);
      const IndexedCloud indexed(cloud, memory);
      measure_spacing(indexed.index, std::nullopt, indexed.stage.context);
      const auto file = indexed.stage.scratch.open(kSpacings);
      std::string bytes(file.size(), '\0');
      file.read_at(0, std::as_writable_bytes(std::span(bytes)));
      if (first.empty()) first = bytes;
      EXPECT_TRUE(bytes == first) << memory << " bytes, threads " << threads;
      EXPECT_LE(indexed.stage.budget.peak(), memory);
    }
  }
}

TEST(MeasureSpacing, IsNotBelowTheWidestOfTheGrid) {
  const auto measured = [](const std::optional<SampleSpacing>& grid) {
    const IndexedCloud indexed(lattice_block(12));
    measure_spacing(indexed.index, grid, indexed.stage.context);
    return indexed.spacings();
  };
  const std::vector<float> free = measured(std::nullopt);
  EXPECT_FLOAT_EQ(*std::min_element(free.begin(), free.end()), 0.1F * std::sqrt(2.0F));
  const std::vector<float> floored = measured(SampleSpacing{0.05, 0.15, 0.1});
  ASSERT_EQ(floored.size(), free.size());
  for (std::size_t i = 0; i < free.size(); ++i) EXPECT_EQ(floored[i], std::max(free[i], 0.15F));
}

TEST(MeasureSpacing, StopsWhenAskedAndRefusesTooLittleMemory) {
  IndexedCloud indexed(lattice_block(12));
  indexed.stage.stop.request();
  EXPECT_THROW(measure_spacing(indexed.index, std::nullopt, indexed.stage.context), Interrupted);
  const StageFixture small(kMebi);
  EXPECT_THROW(measure_spacing(indexed.index, std::nullopt, small.context), BudgetError);
}

}  // namespace
}  // namespace stream_recon
