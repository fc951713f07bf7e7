// The pole store against the stars of the whole cloud in core, however the cloud is cut; and what
// becomes of poles of one ball.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <memory>
#include <numeric>
#include <optional>
#include <ostream>
#include <random>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "engine/labels/evidence_collector.h"
#include "engine/labels/facet_labels.h"
#include "engine/labels/forest_merge.h"
#include "engine/order/external_sort.h"
#include "engine/order/hilbert_sort.h"
#include "engine/order/point_store.h"
#include "engine/parallel.h"
#include "engine/poles/pole_records.h"
#include "engine/poles/pole_stage.h"
#include "engine/poles/pole_store.h"
#include "engine/poles/star_poles.h"
#include "engine/windows/window_stage.h"
#include "spatial/touching_ball.h"
#include "tests/engine_fixture.h"
#include "tests/point_families.h"

namespace stream_recon {
namespace {

using Cloud = std::vector<Point3>;
using Facet = std::array<PointRank, 3>;

constexpr std::uint64_t kMebi = std::uint64_t{1} << 20;

struct How {
  std::uint64_t window_points = 0;
  unsigned threads = 1;
  std::uint64_t memory = 512 * kMebi;
};

struct Stored {
  std::vector<Pole> poles;
  PoleReport counts;
  std::string bytes;
  Cloud points;           ///< by rank
  std::set<Facet> solid;  ///< facets between inside and outside
};

std::vector<Pole> read_poles(StageFixture& stage) {
  const PoleFile file(stage.scratch.open(kPoleStore));
  PoleReader reader(file, stage.budget);
  std::vector<Pole> poles(file.record_count());
  EXPECT_EQ(reader.read(poles), poles.size());
  return poles;
}

void build_windows(const CloudSummary& summary, std::uint64_t points, const How& how,
                   StageFixture& stage) {
  const CloudIndex index = build_index(summary, points, stage.context);
  measure_spacing(index, {}, stage.context);
  SpacingCache spacings(stage.scratch, index, SpacingCache::least_memory(how.threads));
  EvidenceCollector evidence(spacings, stage.stop, {.hands_on_poles = true});
  std::array<WindowConsumer*, 1> consumers{&evidence};
  run_window_stage({index, consumers, {}}, {},
                   {.threads = how.threads,
                    .window_points = how.window_points,
                    .consumer_bytes_a_point = EvidenceCollector::kBytesAnOwnedPoint,
                    .whole_stars = true},
                   stage.context);
}

/// What a run stores of the cloud.
Stored stored_poles(const Cloud& cloud, const How& how) {
  const ThreadLimit threads(how.threads);
  StageFixture stage(how.memory);
  const std::string path = stage.folder / "cloud.f64";
  put_bytes(path, {reinterpret_cast<const char*>(cloud.data()), cloud.size() * sizeof(Point3)});
  const CloudSummary summary = ingest({{path}, InputFormat::kF64}, stage.context);
  const std::uint64_t points = hilbert_sort(summary, stage.context).point_count;
  build_windows(summary, points, how, stage);
  const ExportReader exports(stage.scratch, stage.budget);
  const MergedForest forest = merge_forest(exports, stage.context);
  Stored stored;
  stored.counts = store_poles({exports, forest.labels}, 0, stage.context);
  stored.poles = read_poles(stage);
  stored.bytes = file_bytes(stage.scratch.path() + "/" + kPoleStore);
  label_facets(exports, forest.labels, {.exports = {{points, points}, {}}}, stage.context);
  const ExportReader labelled(stage.scratch, stage.budget, kLabelledPrefix);
  labelled.visit<FacetRecord>(ExportKind::kFacets, 0, [&](std::span<const FacetRecord> facets) {
    for (const FacetRecord& facet : facets) stored.solid.insert(facet.ranks);
  });
  std::vector<std::uint64_t> ranks(points);
  std::iota(ranks.begin(), ranks.end(), 0);
  std::vector<std::uint64_t> indices;
  const PointStoreFile store(stage.scratch.open(kPointStore));
  read_points(store, ranks, stored.points, indices);
  return stored;
}

/// The whole cloud in core, labelled by walking from outside through the solid's facets.
class CoreCloud {
 public:
  explicit CoreCloud(const Stored& stored) : points_(stored.points), indices_(points_.size()) {
    EXPECT_EQ(delaunay_.insert(points_), Delaunay::Outcome::kDone);
    std::vector<CellId> open;
    inside_.resize(delaunay_.cell_slots());
    for (CellId c = 0; c < delaunay_.cell_slots(); ++c) {
      if (delaunay_.is_live(c) && delaunay_.is_infinite(c)) {
        open.push_back(c);
        inside_[c] = false;
      }
    }
    while (!open.empty()) {
      const CellId cell = open.back();
      open.pop_back();
      for (int side = 0; side < 4; ++side) {
        const CellId beyond = delaunay_.neighbor(cell, side);
        if (inside_[beyond]) continue;
        inside_[beyond] = *inside_[cell] != is_solid(cell, side, stored.solid);
        open.push_back(beyond);
      }
    }
  }

  /// What must be stored, and counted.
  std::pair<std::vector<Pole>, PoleReport> poles() const {
    const FinalWindow window({.delaunay = &delaunay_,
                              .first_rank = 0,
                              .owned_count = points_.size(),
                              .guest_ranks = {},
                              .input_indices = indices_});
    const StarBalls balls(window, 1);
    const StarPoles stars(window, balls);
    PoleReport counts;
    std::set<CellId> cells;
    for (VertexId v = 0; v < points_.size(); ++v) {
      const PolePair pair = stars.pair(v);
      counts.unbounded += pair.first == PolePair::kInfinity ? 1 : 0;
      cells.insert({pair.first, pair.second});
    }
    cells.erase(PolePair::kInfinity);
    cells.erase(PolePair::kNone);
    return merged(cells, counts);
  }

 private:
  using Ball = std::tuple<double, double, double, double>;

  bool is_solid(CellId cell, int side, const std::set<Facet>& solid) const {
    Facet facet{};
    int corner = 0;
    const auto v = delaunay_.vertices(cell);
    for (int i = 0; i < 4; ++i) {
      if (i != side) facet[corner++] = v[i];
    }
    std::sort(facet.begin(), facet.end());
    return solid.count(facet) != 0;
  }

  std::pair<std::vector<Pole>, PoleReport> merged(const std::set<CellId>& cells,
                                                  PoleReport counts) const {
    std::map<Ball, std::vector<Pole>> balls;
    for (const CellId cell : cells) {
      auto v = delaunay_.vertices(cell);
      std::sort(v.begin(), v.end());
      const TouchingBall ball =
          touching_ball({points_[v[0]], points_[v[1]], points_[v[2]], points_[v[3]]});
      const Pole pole{.tetrahedron = {{v[0], v[1], v[2], v[3]}},
                      .separation = ball.separation,
                      .is_inside = *inside_[cell],
                      .unused = {},
                      .centre = ball.centre,
                      .radius = ball.radius};
      balls[{ball.centre.x, ball.centre.y, ball.centre.z, ball.radius}].push_back(pole);
    }
    std::vector<Pole> result;
    for (auto& [ball, same] : balls) {
      std::sort(same.begin(), same.end(),
                [](const Pole& a, const Pole& b) { return a.tetrahedron < b.tetrahedron; });
      Pole pole = same.front();
      const auto inside = static_cast<std::size_t>(
          std::count_if(same.begin(), same.end(), [](const Pole& p) { return p.is_inside != 0; }));
      for (const Pole& p : same) pole.separation = std::max(pole.separation, p.separation);
      pole.is_inside = 2 * inside > same.size() ? 1 : 0;
      counts.coincident += same.size() - 1;
      counts.conflicts += inside != 0 && inside != same.size() ? 1 : 0;
      ++(pole.is_inside != 0 ? counts.inner : counts.outer);
      result.push_back(pole);
    }
    counts.count = result.size();
    std::sort(result.begin(), result.end(),
              [](const Pole& a, const Pole& b) { return a.tetrahedron < b.tetrahedron; });
    return {result, counts};
  }

  const Cloud points_;
  const std::vector<std::uint64_t> indices_;
  Delaunay delaunay_;
  std::vector<std::optional<bool>> inside_;
};

void expect_counts(const PoleReport& found, const PoleReport& expected) {
  EXPECT_EQ(found.count, expected.count);
  EXPECT_EQ(found.coincident, expected.coincident);
  EXPECT_EQ(found.unbounded, expected.unbounded);
  EXPECT_EQ(found.inner, expected.inner);
  EXPECT_EQ(found.outer, expected.outer);
  EXPECT_EQ(found.conflicts, expected.conflicts);
}

void expect_poles(const std::vector<Pole>& found, const std::vector<Pole>& expected) {
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t i = 0; i < found.size(); ++i) {
    ASSERT_EQ(found[i].tetrahedron, expected[i].tetrahedron) << i;
    ASSERT_EQ(found[i].centre, expected[i].centre) << i;
    ASSERT_EQ(found[i].radius, expected[i].radius) << i;
    ASSERT_EQ(found[i].separation, expected[i].separation) << i;
    ASSERT_EQ(found[i].is_inside, expected[i].is_inside) << i;
  }
}

Cloud block(int nx, int ny, int nz, const Point3& step) {
  Cloud cloud;
  for (int i = 0; i < nx * ny * nz; ++i) {
    const int layer = i / nx / ny;
    cloud.push_back({step.x * (i % nx), step.y * (i / nx % ny), step.z * layer});
  }
  return cloud;
}

Cloud drawn(int count, Point3 (*draw)(std::mt19937_64&)) {
  std::mt19937_64 random(12);
  Cloud cloud;
  for (int i = 0; i < count; ++i) cloud.push_back(draw(random));
  return cloud;
}

/// The boundary of a box, lattice points.
Cloud shell(int side) {
  Cloud cloud;
  for (const Point3& p : block(side, side, side, {1, 1, 1})) {
    const auto is_end = [side](double x) { return x == 0 || x == side - 1; };
    if (is_end(p.x) || is_end(p.y) || is_end(p.z)) cloud.push_back(p);
  }
  return cloud;
}

struct NamedCloud {
  std::string name;
  Cloud points;
  bool has_coincident = false;
};

void PrintTo(const NamedCloud& cloud, std::ostream* out) {
  *out << cloud.name;
}

class PoleStores : public testing::TestWithParam<NamedCloud> {};

TEST_P(PoleStores, HaveThePolesOfTheWholeCloudAndTheLabelsOfItsSolidHoweverItIsCut) {
  const Stored whole = stored_poles(GetParam().points, {});
  const auto [expected, counts] = CoreCloud(whole).poles();
  expect_poles(whole.poles, expected);
  expect_counts(whole.counts, counts);
  EXPECT_EQ(whole.counts.coincident != 0, GetParam().has_coincident);
  for (const How& how : {How{48, 1}, How{300, 3}, How{160, 2, 48 * kMebi}}) {
    const Stored cut = stored_poles(GetParam().points, how);
    EXPECT_TRUE(cut.bytes == whole.bytes) << how.window_points << " points a window";
    expect_counts(cut.counts, counts);
  }
}

INSTANTIATE_TEST_SUITE_P(
    Clouds, PoleStores,
    testing::Values(NamedCloud{"random", drawn(1200, families::random_point)},
                    NamedCloud{"lattice", block(8, 9, 10, {1, 1, 1}), true},
                    NamedCloud{"slices", block(12, 12, 4, {0.25, 0.25, 0.75}), true},
                    NamedCloud{"shell", shell(11), true},
                    NamedCloud{"sphere", drawn(400, families::sphere_point), true}));

TEST(PoleStores, OfASphereOfRationalPointsHaveOneInnerBall) {
  const Stored stored = stored_poles(drawn(400, families::sphere_point), {});
  const auto inner = std::find_if(stored.poles.begin(), stored.poles.end(),
                                  [](const Pole& pole) { return pole.is_inside != 0; });
  ASSERT_NE(inner, stored.poles.end());
  EXPECT_EQ(stored.counts.inner, 1U);
  EXPECT_EQ(inner->centre, (Point3{0, 0, 0}));
  EXPECT_EQ(inner->radius, 3 * 7 * 9 * 11 * 19);
}

/// Windows that hand on made-up poles.
class MadePoles {
 public:
  MadePoles() = default;
  explicit MadePoles(std::uint64_t memory) : stage_(memory) {}

  void window(PointRank first, const std::vector<std::pair<PoleName, PoleBall>>& poles) {
    ExportWriter out(stage_.scratch, first);
    out.add(ExportKind::kEvidenceNodes, first, NodeKey{{0, 1, 2, 3}});
    out.add(ExportKind::kEvidenceNodes, first, kInfiniteNode);
    for (const auto& [name, ball] : poles) {
      out.add(ExportKind::kPoleNames, first, name);
      out.add(ExportKind::kPoleBalls, first, ball);
    }
    out.finish();
  }

  /// Of tables in which node 0 is outside and node 1 inside.
  Stored store(const std::vector<PointRank>& first_ranks) {
    auto labels = std::make_unique<LabelFile>("labels", first_ranks.size(), stage_.context);
    for (std::size_t i = 0; i < first_ranks.size(); ++i) {
      labels->begin_table(2);
      labels->append(NodeLabel::kOutside);
      labels->append(NodeLabel::kInside);
    }
    labels->finish();
    const ExportReader exports(stage_.scratch, stage_.budget);
    Stored stored;
    const WindowLabels window_labels{first_ranks, std::move(labels), Reservation()};
    stored.counts = store_poles({exports, window_labels}, 0, stage_.context);
    stored.poles = read_poles(stage_);
    return stored;
  }

  StageFixture& stage() { return stage_; }

 private:
  StageFixture stage_;
};

std::pair<PoleName, PoleBall> pole(std::uint32_t lowest, bool is_inside, double x,
                                   float separation = 90) {
  PoleName name{.tetrahedron = {{lowest, lowest + 10, lowest + 20, lowest + 30}},
                .node = {},
                .separation = separation,
                .samples = 1};
  name.node.is_attached = true;
  name.node.node = is_inside ? 1 : 0;
  return {name, {.centre = {x, 0, 0}, .radius = 1}};
}

TEST(PolesOfOneBall, TakeTheLabelOfMostAndAreOutsideIfTheyDoNotAgree) {
  MadePoles made;
  made.window(0, {pole(3, true, 1, 30), pole(1, false, 1, 20), pole(7, true, 2, 50)});
  // The second window found tetrahedron 3 as well: it counts once.
  made.window(5, {pole(3, true, 1, 30), pole(9, false, 2, 40), pole(2, true, 2, 60)});
  const Stored stored = made.store({0, 5});
  ASSERT_EQ(stored.poles.size(), 2U);
  EXPECT_EQ(stored.poles[0].lowest_rank(), 1U);
  EXPECT_EQ(stored.poles[0].is_inside, 0) << "one on either side";
  EXPECT_EQ(stored.poles[0].separation, 30);
  EXPECT_EQ(stored.poles[1].lowest_rank(), 2U);
  EXPECT_EQ(stored.poles[1].is_inside, 1) << "two of three";
  EXPECT_EQ(stored.poles[1].separation, 60);
  expect_counts(stored.counts,
                {.count = 2, .coincident = 3, .inner = 1, .outer = 1, .conflicts = 2});
}

TEST(PolesOfOneBall, AreNotThoseOfOtherCentresOrRadii) {
  MadePoles made;
  auto larger = pole(4, false, 1);
  larger.second.radius = 1 + 0x1p-52;
  made.window(0, {pole(1, false, 1), larger, pole(2, false, 1 + 0x1p-52)});
  EXPECT_EQ(made.store({0}).counts.count, 3U);
}

TEST(PolesWithoutABall, AreCountedBySampleAndLeftOut) {
  MadePoles made;
  auto hull = pole(1, false, 0);
  hull.first.tetrahedron = kInfiniteNode;
  hull.first.samples = 5;
  hull.second.radius = std::numeric_limits<double>::infinity();
  auto huge = pole(2, false, 0);
  huge.second.radius = std::numeric_limits<double>::infinity();
  made.window(0, {huge, pole(3, true, 0), hull});
  const Stored stored = made.store({0});
  EXPECT_EQ(stored.counts.unbounded, 6U);
  ASSERT_EQ(stored.poles.size(), 1U);
  EXPECT_EQ(stored.poles[0].lowest_rank(), 3U);
}

TEST(PoleStores, OfMorePolesThanTheMemoryHoldsAreSortedOnDisk) {
  const std::uint64_t least = ExternalSort<PoleByName>::least_memory();
  MadePoles made(2 * least + 8 * kMebi);
  std::mt19937_64 random(13);
  std::map<std::uint32_t, double> centres;
  std::vector<std::pair<PoleName, PoleBall>> poles;
  for (std::uint32_t i = 0; i < 300000; ++i) {
    const auto lowest = static_cast<std::uint32_t>(random() % 200000);
    const auto at = centres.try_emplace(lowest, static_cast<double>(random() % 100000)).first;
    poles.push_back(pole(lowest, at->second < 50000, at->second));
  }
  made.window(0, poles);
  const Stored stored = made.store({0});
  std::map<double, std::uint32_t> lowest;
  for (const auto& [rank, centre] : centres) lowest.try_emplace(centre, rank);
  std::map<std::uint32_t, double> expected;
  for (const auto& [centre, rank] : lowest) expected[rank] = centre;
  ASSERT_EQ(stored.poles.size(), expected.size());
  auto next = expected.begin();
  for (const Pole& found : stored.poles) {
    ASSERT_EQ(found.lowest_rank(), next->first);
    ASSERT_EQ(found.centre.x, next->second);
    ASSERT_EQ(found.is_inside, next->second < 50000 ? 1 : 0);
    ++next;
  }
  EXPECT_EQ(stored.counts.coincident, centres.size() - expected.size());
  for (const std::string& name : made.stage().scratch.names()) {
    EXPECT_EQ(name.find("_run_"), std::string::npos) << name;
  }
}

}  // namespace
}  // namespace stream_recon
