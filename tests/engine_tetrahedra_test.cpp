// From tetrahedra to chunks: the same files whatever the windows and the order they come in.

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>
#include <set>
#include <string>
#include <thread>
#include <vector>

#include "engine/chunks/chunk_vertices.h"
#include "engine/order/point_store.h"
#include "engine/tetrahedra/tetrahedra_assembly.h"
#include "engine/tetrahedra/tetrahedra_collector.h"
#include "engine/windows/export_writer.h"
#include "tests/engine_fixture.h"

namespace stream_recon {
namespace {

/// A cloud on a small lattice, so full of ties; its order is as good as any curve's.
std::vector<StoredPoint> lattice_cloud() {
  std::vector<StoredPoint> cloud;
  for (std::uint64_t i = 0; i < 7 * 7 * 7; ++i) {
    const Point3 point{static_cast<double>(i % 7), static_cast<double>(i / 7 % 7),
                       static_cast<double>(i / 49)};
    cloud.push_back({point, 1000 - i});
  }
  std::shuffle(cloud.begin(), cloud.end(), std::mt19937_64(3));
  return cloud;
}

/// A window that owns some of the cloud and has all the rest as guests, so that it is final.
class Window {
 public:
  Window(const std::vector<StoredPoint>& cloud, PointRank first, std::uint64_t owned)
      : first_(first), owned_(owned) {
    std::vector<PointRank> ranks(cloud.size());
    std::iota(ranks.begin(), ranks.end(), 0);
    std::rotate(ranks.begin(), ranks.begin() + static_cast<std::ptrdiff_t>(first), ranks.end());
    std::vector<Point3> points;
    for (const PointRank rank : ranks) {
      points.push_back(cloud[rank].point);
      input_indices_.push_back(cloud[rank].input_index);
    }
    guests_.assign(ranks.begin() + static_cast<std::ptrdiff_t>(owned), ranks.end());
    EXPECT_EQ(delaunay_.insert(points), Delaunay::Outcome::kDone);
  }

  FinalWindow view() const {
    return FinalWindow({.delaunay = &delaunay_,
                        .first_rank = first_,
                        .owned_count = owned_,
                        .guest_ranks = guests_,
                        .input_indices = input_indices_});
  }

 private:
  PointRank first_;
  std::uint64_t owned_;
  std::vector<PointRank> guests_;
  std::vector<std::uint64_t> input_indices_;
  Delaunay delaunay_;
};

/// All bytes of the output when the cloud is cut into windows that are consumed side by side.
std::string written(const std::vector<StoredPoint>& cloud, std::uint64_t points_per_window) {
  StageFixture stage;
  auto store = create_records<StoredPoint>(stage.scratch, kPointStore, kPointStoreBlock);
  store.append(cloud);
  store.finish();
  const ChunkLayout layout{50, cloud.size()};
  TetrahedraCollector collector(layout, stage.stop);
  {
    std::vector<std::jthread> threads;
    for (PointRank first = 0; first < cloud.size(); first += points_per_window) {
      threads.emplace_back([&, first] {
        const Window window(cloud, first, std::min(points_per_window, cloud.size() - first));
        ExportWriter out(stage.scratch, first);
        collector.consume(window.view(), out);
        out.finish();
      });
    }
  }
  TetrahedraWriter writer({stage.folder / "t.pvtu"});
  const ExportReader exports(stage.scratch, stage.budget);
  assemble_tetrahedra({exports, layout}, writer, stage.context);
  writer.prepare();
  writer.publish();
  writer.keep();
  std::string bytes = file_bytes(stage.folder / "t.pvtu");
  for (const std::string& chunk : list_folder(stage.folder / "t")) {
    bytes += chunk + file_bytes(stage.folder / "t/" + chunk);
  }
  return bytes;
}

TEST(TetrahedraOutput, HasTheSameBytesHoweverTheCloudIsCutIntoWindows) {
  const auto cloud = lattice_cloud();
  const std::string whole = written(cloud, cloud.size());
  EXPECT_NE(whole.find("chunk_000005.vtu"), std::string::npos);
  for (std::uint64_t points_per_window : {200, 70, 50}) {
    EXPECT_TRUE(written(cloud, points_per_window) == whole) << points_per_window;
  }
}

TEST(ChunkVertices, NumberDistinctRanksInTheirOrder) {
  MemoryBudget budget(std::uint64_t{1} << 30);
  ChunkVertices vertices(100, 400, budget);
  std::set<PointRank> expected;
  std::mt19937_64 random(1);
  for (int i = 0; i < 100000; ++i) {
    const PointRank rank = 100 + (i % 2 == 0 ? random() % 300 : random() % 30000);
    vertices.add(rank);
    expected.insert(rank);
  }
  vertices.number();
  ASSERT_EQ(vertices.size(), expected.size());
  std::uint32_t position = 0;
  for (const PointRank rank : expected) ASSERT_EQ(vertices.position(rank), position++);
  std::vector<PointRank> visited;
  vertices.for_each([&](PointRank rank) { visited.push_back(rank); });
  EXPECT_TRUE(std::equal(visited.begin(), visited.end(), expected.begin(), expected.end()));
}

TEST(ChunkVertices, OutgrowTheirBudgetWithAnError) {
  MemoryBudget budget(std::uint64_t{1} << 16);
  ChunkVertices vertices(0, 100, budget);
  EXPECT_THROW(for (PointRank rank = 0; rank < 10000; ++rank) vertices.add(rank), BudgetError);
}

}  // namespace
}  // namespace stream_recon
