// Surfaces of solids: closed, facing outward, counted as an oracle in core counts them, however the
// cloud is chunked and whatever memory and threads there are.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <random>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "engine/order/point_store.h"
#include "engine/parallel.h"
#include "engine/scratch_records.h"
#include "engine/surface/assembly.h"
#include "engine/surface/closure_code.h"
#include "io/point_source.h"
#include "spatial/triangle_measure.h"
#include "tests/engine_fixture.h"
#include "tests/labelled_cells.h"
#include "tests/recording_writer.h"

namespace stream_recon {
namespace {

struct Outcome {
  SurfaceFacts facts;
  std::vector<SurfaceChunk> chunks;
  std::vector<Point3> unused;
};

struct How {
  std::uint64_t points_per_chunk = 1000000;
  bool in_order = true;
  unsigned threads = 4;
  std::uint64_t memory = std::uint64_t{1} << 30;
  std::uint64_t records_per_window = 100;
  std::optional<double> open_ratio = {};
};

void store_points(const std::vector<Point3>& points, StageFixture& stage) {
  auto store = create_records<StoredPoint>(stage.scratch, kPointStore, kPointStoreBlock);
  for (std::uint64_t rank = 0; rank < points.size(); ++rank) store.append({points[rank], 7 * rank});
  store.finish();
}

Outcome assemble(const std::vector<Point3>& points, std::vector<FacetRecord> records,
                 const How& how) {
  const ThreadLimit threads(how.threads);
  StageFixture stage;
  store_points(points, stage);
  const ChunkLayout layout{how.points_per_chunk, points.size()};
  std::shuffle(records.begin(), records.end(), std::mt19937_64(how.records_per_window));
  for (std::size_t first = 0; first < records.size(); first += how.records_per_window) {
    ExportWriter out(stage.scratch, first);
    const auto count = std::min<std::size_t>(how.records_per_window, records.size() - first);
    export_solid_facets(std::span(records).subspan(first, count), {layout, how.open_ratio}, out);
    out.finish();
  }
  const ExportReader exports(stage.scratch, stage.budget);
  const Reservation others =
      stage.budget.reserve(stage.budget.available() - how.memory, "everything else");
  RecordingWriter writer(how.in_order);
  PointsWriter unused({stage.folder / "unused.ply", Scalar::kFloat64, &stage.scratch});
  CoordinateRange range;
  for (const Point3& p : points) range.extend(p);
  Outcome outcome{assemble_surface({exports, layout}, writer, stage.context,
                                   {.is_solid = true, .range = range, .unused = &unused}),
                  writer.chunks,
                  {}};
  EXPECT_FALSE(stage.scratch.has("shared_edges"));
  unused.prepare();
  unused.publish();
  unused.keep();
  const auto source = open_point_source(stage.folder / "unused.ply", InputFormat::kAuto);
  outcome.unused.resize(points.size() + 1);
  std::size_t count = 0;
  while (const std::size_t got = source->read(std::span(outcome.unused).subspan(count))) {
    count += got;
  }
  outcome.unused.resize(count);
  return outcome;
}

void expect_facts(const SurfaceFacts& found, const LabelledCells::Facts& expected) {
  EXPECT_EQ(found.components, expected.components);
  EXPECT_EQ(found.cavities, expected.cavities);
  EXPECT_EQ(found.genus, expected.genus);
  ASSERT_TRUE(found.volume.has_value());
  EXPECT_NEAR(*found.volume, expected.volume, 1e-9 * (1 + expected.volume));
  EXPECT_NEAR(found.area, expected.area, 1e-9 * (1 + expected.area));
  EXPECT_EQ(found.counts.vertices, expected.vertices);
  EXPECT_EQ(found.counts.nonmanifold_edges, expected.nonmanifold_edges);
  EXPECT_EQ(found.counts.boundary_edges, 0U);
}

/// Each edge is run along as often in one direction as in the other, in the chunks as written.
void expect_consistent(const std::vector<SurfaceChunk>& chunks) {
  std::map<std::pair<std::uint64_t, std::uint64_t>, int> balance;
  DoubleDouble volume;
  for (const SurfaceChunk& chunk : chunks) {
    for (const auto& v : chunk.triangles) {
      for (int i = 0; i < 3; ++i) {
        const std::uint64_t a = chunk.global_ids[v[i]];
        const std::uint64_t b = chunk.global_ids[v[(i + 1) % 3]];
        balance[{std::min(a, b), std::max(a, b)}] += a < b ? 1 : -1;
      }
      volume =
          volume + six_cone_volumes(chunk.points[v[0]], chunk.points[v[1]], chunk.points[v[2]]);
    }
  }
  EXPECT_TRUE(
      std::all_of(balance.begin(), balance.end(), [](const auto& e) { return e.second == 0; }));
  EXPECT_EQ(volume.value() > 0, !chunks.empty());
}

void expect_same(const Outcome& found, const Outcome& expected) {
  ASSERT_EQ(found.chunks.size(), expected.chunks.size());
  for (std::size_t c = 0; c < found.chunks.size(); ++c) {
    EXPECT_EQ(found.chunks[c].triangles, expected.chunks[c].triangles);
    EXPECT_EQ(found.chunks[c].closure, expected.chunks[c].closure);
    EXPECT_EQ(found.chunks[c].source, expected.chunks[c].source);
    EXPECT_EQ(found.chunks[c].points, expected.chunks[c].points);
    EXPECT_EQ(found.chunks[c].global_ids, expected.chunks[c].global_ids);
  }
  EXPECT_EQ(found.facts.volume, expected.facts.volume) << "not the same bits";
  EXPECT_EQ(found.facts.area, expected.facts.area) << "not the same bits";
  EXPECT_EQ(found.facts.components, expected.facts.components);
  EXPECT_EQ(found.facts.counts.digest.hex(), expected.facts.counts.digest.hex());
  EXPECT_EQ(found.unused, expected.unused);
}

/// Random points and labels: edges and vertices where many sheets meet.
LabelledCells random_solid(std::size_t count, std::uint64_t seed, unsigned inside_of_10) {
  std::mt19937_64 random(seed);
  std::vector<Point3> points;
  // On a coarse lattice: many facets are coplanar around their edges.
  std::uniform_int_distribution<int> coordinate(0, 9);
  const auto draw = [&] { return static_cast<double>(coordinate(random)); };
  std::set<Point3> distinct;
  while (distinct.size() < count) distinct.insert({draw(), draw(), draw()});
  points.assign(distinct.begin(), distinct.end());
  std::shuffle(points.begin(), points.end(), random);
  return LabelledCells(points, [&](const Point3&) { return random() % 10 < inside_of_10; });
}

class RandomSolid : public testing::TestWithParam<unsigned> {};

TEST_P(RandomSolid, IsCountedAsByWalksThroughItsCellsHoweverItIsChunked) {
  const LabelledCells solid = random_solid(300, GetParam(), GetParam());
  const auto expected = solid.facts();
  EXPECT_GT(expected.nonmanifold_edges, 100U);
  for (const std::uint64_t points_per_chunk : {1, 7, 50, 299, 5000}) {
    SCOPED_TRACE(points_per_chunk);
    const Outcome outcome =
        assemble(solid.points(), solid.records(), {.points_per_chunk = points_per_chunk});
    expect_facts(outcome.facts, expected);
    expect_consistent(outcome.chunks);
  }
}

TEST_P(RandomSolid, IsTheSameForAnyWindowsMemoryAndThreads) {
  const LabelledCells solid = random_solid(300, 50 + GetParam(), GetParam());
  const How usual{.points_per_chunk = 40};
  const Outcome expected = assemble(solid.points(), solid.records(), usual);
  const How alone{.points_per_chunk = 40, .threads = 1, .records_per_window = 100000};
  const How side_by_side{.points_per_chunk = 40, .in_order = false, .records_per_window = 37};
  const How in_little{.points_per_chunk = 40, .in_order = false, .memory = std::uint64_t{9} << 20};
  for (const How& how : {alone, side_by_side, in_little}) {
    expect_same(assemble(solid.points(), solid.records(), how), expected);
  }
}

INSTANTIATE_TEST_SUITE_P(Labels, RandomSolid, testing::Values(2, 5, 8));

struct Shape {
  std::string name;
  Voxels voxels;
  std::uint64_t components = 1;
  std::uint64_t cavities = 0;
  std::int64_t genus = 0;
  double area = 0;
};

void PrintTo(const Shape& shape, std::ostream* out) {
  *out << shape.name;
}

Voxels ring(int z) {
  Voxels voxels;
  for (int i = 0; i < 9; ++i) voxels.insert({1 + i % 3, 1 + i / 3, z});
  voxels.erase({2, 2, z});
  return voxels;
}

Voxels block(int size) {
  Voxels voxels;
  for (int i = 0; i < size * size * size; ++i) {
    voxels.insert({i % size, i / size % size, i / size / size});
  }
  return voxels;
}

Voxels without(Voxels voxels, std::array<int, 3> hole) {
  voxels.erase(hole);
  return voxels;
}

Voxels both(Voxels a, const Voxels& b) {
  a.insert(b.begin(), b.end());
  return a;
}

class SimpleSolid : public testing::TestWithParam<Shape> {};

TEST_P(SimpleSolid, HasTheNumbersOfItsShape) {
  const Shape& shape = GetParam();
  for (const std::uint64_t seed : {1, 2, 3}) {
    const LabelledCells solid = voxel_solid(shape.voxels, 6, seed);
    for (const std::uint64_t points_per_chunk : {1, 9, 70, 216}) {
      SCOPED_TRACE(points_per_chunk);
      const Outcome outcome =
          assemble(solid.points(), solid.records(), {.points_per_chunk = points_per_chunk});
      expect_facts(outcome.facts, solid.facts());
      expect_consistent(outcome.chunks);
      EXPECT_EQ(outcome.facts.components, shape.components);
      EXPECT_EQ(outcome.facts.cavities, shape.cavities);
      EXPECT_EQ(outcome.facts.genus, shape.genus);
      EXPECT_EQ(outcome.facts.volume, static_cast<double>(shape.voxels.size()));
      EXPECT_NEAR(outcome.facts.area, shape.area, 1e-12);
      EXPECT_EQ(outcome.unused.size() + outcome.facts.counts.vertices, solid.points().size());
    }
  }
}

INSTANTIATE_TEST_SUITE_P(
    Shapes, SimpleSolid,
    testing::Values(Shape{"a cube", {{2, 2, 2}}, 1, 0, 0, 6},
                    Shape{"a cube in a cube", without(block(3), {1, 1, 1}), 1, 1, 0, 60},
                    Shape{"two cubes at an edge", {{1, 1, 1}, {2, 2, 1}}, 2, 0, 0, 12},
                    Shape{"two cubes at a vertex", {{1, 1, 1}, {2, 2, 2}}, 2, 0, 0, 12},
                    Shape{"two cubes apart", {{0, 0, 0}, {3, 3, 3}}, 2, 0, 0, 12},
                    Shape{"a torus", ring(1), 1, 0, 1, 32},
                    Shape{"two tori", both(ring(1), ring(3)), 2, 0, 2, 64},
                    Shape{"nothing", {}, 0, 0, 0, 0}));

TEST(OpenSolid, LeavesOutTheFillsOfALargeClosureAsIfTheyWereNotThere) {
  const LabelledCells solid = random_solid(300, 9, 4);
  const std::vector<FacetRecord> all = solid.records();
  std::vector<FacetRecord> kept;
  std::map<std::pair<PointRank, PointRank>, int> edges;
  std::set<PointRank> vertices;
  for (const FacetRecord& f : all) {
    if (f.source == TriangleSource::kFill && closure_of_code(f.closure) > 5) continue;
    kept.push_back(f);
    vertices.insert(f.ranks.begin(), f.ranks.end());
    for (const auto& [a, b] : {std::pair(0, 1), std::pair(0, 2), std::pair(1, 2)}) {
      ++edges[{f.ranks[a], f.ranks[b]}];
    }
  }
  ASSERT_LT(kept.size(), all.size());
  const auto of_one =
      std::count_if(edges.begin(), edges.end(), [](const auto& edge) { return edge.second == 1; });
  const Outcome whole = assemble(solid.points(), kept, {});
  for (const std::uint64_t points_per_chunk : {1, 40, 5000}) {
    const Outcome outcome =
        assemble(solid.points(), all, {.points_per_chunk = points_per_chunk, .open_ratio = 5});
    const SurfaceFacts& facts = outcome.facts;
    EXPECT_EQ(facts.counts.triangles, kept.size());
    EXPECT_EQ(facts.counts.vertices, vertices.size());
    EXPECT_EQ(facts.counts.edges, edges.size());
    EXPECT_EQ(facts.counts.boundary_edges, static_cast<std::uint64_t>(of_one));
    EXPECT_FALSE(facts.volume || facts.genus) << "it is not closed";
    EXPECT_EQ(facts.components, whole.facts.components);
    EXPECT_EQ(facts.cavities, whole.facts.cavities);
    std::vector<Point3> unused;
    for (PointRank rank = 0; rank < solid.points().size(); ++rank) {
      if (vertices.count(rank) == 0) unused.push_back(solid.points()[rank]);
    }
    EXPECT_EQ(outcome.unused, unused);
  }
}

TEST(OpenSolid, OfACubeWithoutALidIsOnePieceThatIsNotClosed) {
  const LabelledCells cube = voxel_solid({{1, 1, 1}, {3, 3, 3}}, 5);
  std::vector<FacetRecord> records = cube.records();
  for (FacetRecord& facet : records) {
    const bool is_lid = std::all_of(facet.ranks.begin(), facet.ranks.end(),
                                    [&](PointRank rank) { return cube.points()[rank].z == 2; });
    facet.source = TriangleSource::kFill;
    facet.closure = closure_code(is_lid ? 6 : 1);
  }
  const Outcome closed = assemble(cube.points(), records, {.points_per_chunk = 11});
  EXPECT_EQ(closed.facts.counts.doubtful_fills, 2U);
  EXPECT_EQ(closed.facts.volume, 2);
  const Outcome open =
      assemble(cube.points(), records, {.points_per_chunk = 11, .open_ratio = 5.5});
  EXPECT_EQ(open.facts.counts.triangles, 22U);
  EXPECT_EQ(open.facts.counts.boundary_edges, 4U);
  EXPECT_EQ(open.facts.counts.doubtful_fills, 0U);
  EXPECT_EQ(open.facts.components, 2U);
  EXPECT_EQ(open.facts.cavities, 0U);
  EXPECT_FALSE(open.facts.genus || open.facts.volume);
}

TEST(SolidVolume, OfAThinHollowFarAwayIsStillNegative) {
  // Boxes of 2^-30 height, 10^6 away from the origin: a double would lose them.
  std::vector<Point3> points = lattice_points(4, 5);
  for (Point3& p : points) {
    p = {1e6 + p.x, 1e6 + p.y, 1e6 + (p.z == 2 ? 1 + 0x1p-30 : std::min(p.z, 2.0))};
  }
  const LabelledCells solid(points, [](const Point3& p) {
    const bool is_hollow = std::abs(p.x - 1e6 - 1.5) < 0.5 && std::abs(p.y - 1e6 - 1.5) < 0.5 &&
                           p.z > 1e6 + 1 && p.z < 1e6 + 1 + 0x1p-30;
    return !is_hollow;
  });
  const Outcome outcome = assemble(points, solid.records(), {.points_per_chunk = 5});
  EXPECT_EQ(outcome.facts.components, 1U);
  EXPECT_EQ(outcome.facts.cavities, 1U);
  EXPECT_EQ(outcome.facts.volume, 18 - 0x1p-30);
}

TEST(SolidVolume, OfCoordinatesBeyondTheSafeRangeIsScaled) {
  const LabelledCells torus = voxel_solid(ring(1), 5);
  for (const double scale : {0x1p+210, 0x1p-210}) {
    std::vector<Point3> points = torus.points();
    for (Point3& p : points) p = scaled(p, scale);
    const Outcome outcome = assemble(points, torus.records(), {.points_per_chunk = 20});
    EXPECT_EQ(outcome.facts.volume, 8 * scale * scale * scale);
    EXPECT_EQ(outcome.facts.genus, 1);
    EXPECT_EQ(outcome.facts.cavities, 0U);
  }
}

TEST(ClosureCode, KeepsEightBitsAndTheOrder) {
  EXPECT_EQ(closure_code(0), kUnknownClosure);
  EXPECT_EQ(closure_code(-1), kUnknownClosure);
  EXPECT_EQ(closure_code(std::nanf("")), kUnknownClosure);
  EXPECT_EQ(closure_of_code(kUnknownClosure), 0);
  EXPECT_EQ(closure_of_code(closure_code(4)), 4);
  EXPECT_GT(closure_of_code(closure_code(INFINITY)), 1e38F);
  EXPECT_TRUE(std::isfinite(closure_of_code(closure_code(INFINITY))));
  EXPECT_GT(closure_of_code(closure_code(1e-45F)), 0);
  std::uint16_t last = 0;
  for (float closure = 1e-3F; closure < 1e3F; closure *= 1.0007F) {
    const std::uint16_t code = closure_code(closure);
    EXPECT_GE(code, last);
    EXPECT_NEAR(closure_of_code(code) / closure, 1, 1.0 / 256);
    last = code;
  }
}

TEST(DoubleDoubles, KeepWhatDoublesLose) {
  const DoubleDouble sum = exact_sum(1e16, 1) + DoubleDouble{-1e16, 0};
  EXPECT_EQ(sum.value(), 1);
  const DoubleDouble square = exact_product(1 + 0x1p-40, 1 + 0x1p-40);
  EXPECT_EQ((square - DoubleDouble{1 + 0x1p-39, 0}).value(), 0x1p-80);
  EXPECT_EQ((exact_product(0.1, 3) * 10 - exact_product(1, 3)).value(),
            30 * 0x1.999999999999ap-4L - 3);
}

}  // namespace
}  // namespace stream_recon
