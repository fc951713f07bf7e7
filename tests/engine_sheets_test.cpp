// Splitting the surface of a solid into sheets: against an oracle in core, and what it promises.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <random>
#include <set>
#include <stdexcept>
#include <utility>
#include <vector>

#include "engine/order/point_store.h"
#include "engine/parallel.h"
#include "engine/restart/run_identity.h"
#include "engine/scratch_records.h"
#include "engine/surface/assembly.h"
#include "engine/surface/surface_sheets.h"
#include "engine/surface/vertex_sheets.h"
#include "io/error.h"
#include "io/mesh_source.h"
#include "tests/engine_fixture.h"
#include "tests/mesh_oracle.h"
#include "tests/point_families.h"
#include "tests/recording_writer.h"
#include "tests/sheet_oracle.h"

namespace stream_recon {
namespace {

using Triangle = SheetOracle::Triangle;

/// What the windows leave behind: the point store, whose input indices are ten times the ranks, and
/// the exported facets, shuffled.
class Exported {
 public:
  Exported(const std::vector<Point3>& points, std::vector<FacetRecord> records,
           std::uint64_t points_per_chunk)
      : layout{points_per_chunk, points.size()} {
    auto store = create_records<StoredPoint>(stage.scratch, kPointStore, kPointStoreBlock);
    for (std::size_t i = 0; i < points.size(); ++i) {
      range.extend(points[i]);
      store.append(StoredPoint{points[i], 10 * i});
    }
    store.finish();
    std::shuffle(records.begin(), records.end(), std::mt19937_64(points_per_chunk));
    ExportWriter out(stage.scratch, 0);
    export_solid_facets(records, {layout, {}}, out);
    out.finish();
  }

  SurfaceFacts assemble(SurfaceWriter& writer, std::uint64_t memory = std::uint64_t{1} << 30) {
    const ExportReader exports(stage.scratch, stage.budget);
    const Reservation others =
        stage.budget.reserve(stage.budget.available() - memory, "everything else");
    return assemble_surface({exports, layout}, writer, stage.context,
                            {.is_solid = true, .splits = true, .range = range});
  }

  StageFixture stage;
  ChunkLayout layout;
  CoordinateRange range;
};

struct Assembled {
  SurfaceFacts facts;
  std::vector<SurfaceChunk> chunks;
};

struct AssemblyCase {
  std::uint64_t points_per_chunk = 1000;
  bool in_order = true;
  std::uint64_t memory = std::uint64_t{1} << 30;
};

Assembled assemble(const SheetOracle& oracle, const AssemblyCase& how = {}) {
  Exported exported(oracle.points(), oracle.records(), how.points_per_chunk);
  RecordingWriter keeper(how.in_order);
  const SurfaceFacts facts = exported.assemble(keeper, how.memory);
  return {facts, keeper.chunks};
}

/// The sheets of the corners, by triangle.
std::map<Triangle, Triangle> sheets_of(const std::vector<SurfaceChunk>& chunks) {
  std::map<Triangle, Triangle> sheets;
  for (const SurfaceChunk& chunk : chunks) {
    EXPECT_EQ(chunk.sheets.size(), chunk.points.size());
    for (const auto& triangle : chunk.triangles) {
      std::array<std::pair<std::uint32_t, std::uint32_t>, 3> corners;
      for (int i = 0; i < 3; ++i) {
        const std::uint32_t v = triangle[i];
        corners[i] = {static_cast<std::uint32_t>(chunk.global_ids[v] / 10), chunk.sheets[v]};
      }
      std::sort(corners.begin(), corners.end());
      sheets[{corners[0].first, corners[1].first, corners[2].first}] = {
          corners[0].second, corners[1].second, corners[2].second};
    }
  }
  return sheets;
}

/// The whole mesh, its vertices told apart by id and sheet.
TestMesh stitched(const std::vector<SurfaceChunk>& chunks) {
  TestMesh mesh;
  std::map<std::pair<std::uint64_t, std::uint32_t>, std::uint32_t> number;
  for (const SurfaceChunk& chunk : chunks) {
    std::vector<std::uint32_t> numbers;
    for (std::size_t v = 0; v < chunk.points.size(); ++v) {
      const auto next = static_cast<std::uint32_t>(number.size());
      const auto [at, is_new] = number.try_emplace({chunk.global_ids[v], chunk.sheets[v]}, next);
      if (is_new) mesh.points.push_back(chunk.points[v]);
      EXPECT_EQ(mesh.points[at->second], chunk.points[v]);
      numbers.push_back(at->second);
    }
    for (const auto& t : chunk.triangles) {
      mesh.triangles.push_back({numbers[t[0]], numbers[t[1]], numbers[t[2]]});
    }
  }
  return mesh;
}

void expect_manifold(const TestMesh& mesh) {
  const MeshFacts facts = MeshOracle(mesh).facts();
  EXPECT_EQ(facts.boundary_edges, 0U);
  EXPECT_EQ(facts.nonmanifold_edges, 0U);
  EXPECT_EQ(facts.nonmanifold_vertices, 0U);
  EXPECT_EQ(facts.wrongly_oriented_edges, 0U);
  EXPECT_EQ(facts.duplicate_triangles, 0U);
  EXPECT_EQ(facts.unused_vertices, 0U);
}

/// Cavities are components of the mesh.
void expect_counts(const SurfaceFacts& found, const TestMesh& mesh) {
  const MeshFacts facts = MeshOracle(mesh).facts();
  EXPECT_EQ(found.counts.vertices, facts.vertices);
  EXPECT_EQ(found.counts.edges, facts.edges);
  EXPECT_EQ(found.counts.triangles, facts.triangles);
  EXPECT_EQ(found.counts.boundary_edges, 0U);
  EXPECT_EQ(found.counts.nonmanifold_edges, 0U);
  EXPECT_EQ(found.counts.euler(), facts.euler());
  EXPECT_EQ(found.components + found.cavities, facts.components);
  const auto pieces = static_cast<std::int64_t>(facts.components);
  EXPECT_EQ(found.genus, pieces - facts.euler() / 2);
}

SheetOracle::IsInside random_labels(double share, std::uint64_t seed) {
  return [share, random = std::mt19937_64(seed)](const Point3&) mutable {
    return std::uniform_real_distribution<double>(0, 1)(random) < share;
  };
}

std::vector<Point3> random_points(std::size_t count, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::vector<Point3> points;
  for (std::size_t i = 0; i < count; ++i) points.push_back(families::random_point(random));
  return points;
}

/// All points of an n x n x n lattice of unit steps, shuffled.
std::vector<Point3> lattice(int n, std::uint64_t seed) {
  std::vector<Point3> points;
  points.reserve(static_cast<std::size_t>(n) * n * n);
  for (int x = 0; x < n; ++x) {
    for (int y = 0; y < n; ++y) {
      for (int z = 0; z < n; ++z) points.push_back({1.0 * x, 1.0 * y, 1.0 * z});
    }
  }
  std::shuffle(points.begin(), points.end(), std::mt19937_64(seed));
  return points;
}

/// Unit cubes of the lattice, by their lowest corners.
using Voxels = std::set<std::array<int, 3>>;

SheetOracle voxel_solid(const Voxels& voxels, int n, std::uint64_t seed = 1) {
  return {lattice(n, seed), [&voxels](const Point3& p) {
            return voxels.count(
                       {static_cast<int>(p.x), static_cast<int>(p.y), static_cast<int>(p.z)}) != 0;
          }};
}

Voxels all_but(const Voxels& holes, int n) {
  Voxels voxels;
  for (int i = 0; i < n * n * n; ++i) voxels.insert({i % n, i / n % n, i / n / n});
  for (const auto& hole : holes) voxels.erase(hole);
  return voxels;
}

class RandomLabels : public testing::TestWithParam<std::tuple<int, double>> {
 protected:
  SheetOracle make(std::uint64_t seed) const {
    const auto [kind, share] = GetParam();
    std::vector<Point3> points;
    if (kind == 0) points = random_points(300, seed);
    if (kind == 1) points = lattice(6, seed);
    if (kind == 2) {
      std::mt19937_64 random(seed);
      std::set<Point3> distinct;
      while (distinct.size() < 250) {
        distinct.insert(families::nudged(families::lattice_point(random, 3, 1), random));
      }
      points.assign(distinct.begin(), distinct.end());
      std::shuffle(points.begin(), points.end(), random);
    }
    return {points, random_labels(share, seed)};
  }
};

TEST_P(RandomLabels, AreSplitAsTheCellsSay) {
  std::uint64_t turned = 0;
  for (std::uint64_t seed : {1, 2, 3}) {
    const SheetOracle oracle = make(seed);
    EXPECT_GT(oracle.multiple_edges(), 30U);
    turned += oracle.turned_edges();
    const Assembled found = assemble(oracle, {.points_per_chunk = 40});
    EXPECT_EQ(sheets_of(found.chunks), oracle.sheets());
    const TestMesh mesh = stitched(found.chunks);
    expect_manifold(mesh);
    expect_counts(found.facts, mesh);
  }
  if (std::get<1>(GetParam()) > 0.4) {
    EXPECT_GT(turned, 0U);
  }
}

TEST_P(RandomLabels, AreSplitAlikeHoweverTheCloudIsChunked) {
  const SheetOracle oracle = make(4);
  for (std::uint64_t points_per_chunk : {1, 7, 1000}) {
    const Assembled found = assemble(oracle, {.points_per_chunk = points_per_chunk});
    EXPECT_EQ(sheets_of(found.chunks), oracle.sheets()) << points_per_chunk;
    expect_counts(found.facts, stitched(found.chunks));
  }
}

TEST_P(RandomLabels, NumberEachCopyInTheOrderOfFirstAppearance) {
  const SheetOracle oracle = make(5);
  for (std::uint64_t points_per_chunk : {1, 7, 60, 1000}) {
    const Assembled found = assemble(oracle, {.points_per_chunk = points_per_chunk});
    std::map<std::pair<std::uint64_t, std::uint32_t>, std::uint64_t> number;
    for (const SurfaceChunk& chunk : found.chunks) {
      for (std::size_t v = 0; v < chunk.points.size(); ++v) {
        const auto [at, is_new] =
            number.try_emplace({chunk.global_ids[v], chunk.sheets[v]}, number.size());
        EXPECT_EQ(chunk.vertex_numbers[v], at->second)
            << (is_new ? "new" : "known") << " vertex, chunks of " << points_per_chunk;
      }
    }
    EXPECT_EQ(number.size(), found.facts.counts.vertices);
    std::set<std::uint64_t> samples;
    for (const auto& [vertex, place] : number) samples.insert(vertex.first);
    EXPECT_EQ(found.facts.samples, samples.size());
    EXPECT_LT(found.facts.samples, found.facts.counts.vertices);
  }
}

INSTANTIATE_TEST_SUITE_P(Sheets, RandomLabels,
                         testing::Combine(testing::Values(0, 1, 2),
                                          testing::Values(0.2, 0.5, 0.8)));

TEST(Sheets, AreTheSameSideBySideAndInLittleMemory) {
  const SheetOracle oracle(random_points(2000, 7), random_labels(0.4, 7));
  const Assembled expected = assemble(oracle, {.points_per_chunk = 100});
  const std::uint64_t little = std::uint64_t{22} << 20;
  const AssemblyCase side_by_side{.points_per_chunk = 100, .in_order = false};
  const AssemblyCase one_by_one{.points_per_chunk = 100, .in_order = false, .memory = little};
  const AssemblyCase in_little{.points_per_chunk = 100, .in_order = true, .memory = little};
  for (const AssemblyCase& how : {side_by_side, one_by_one, in_little}) {
    const ThreadLimit threads(how.memory == little ? 2 : 4);
    const Assembled found = assemble(oracle, how);
    ASSERT_EQ(found.chunks.size(), expected.chunks.size());
    for (std::size_t c = 0; c < found.chunks.size(); ++c) {
      EXPECT_EQ(found.chunks[c].triangles, expected.chunks[c].triangles);
      EXPECT_EQ(found.chunks[c].points, expected.chunks[c].points);
      EXPECT_EQ(found.chunks[c].global_ids, expected.chunks[c].global_ids);
      EXPECT_EQ(found.chunks[c].sheets, expected.chunks[c].sheets);
      if (how.in_order) {
        EXPECT_EQ(found.chunks[c].vertex_numbers, expected.chunks[c].vertex_numbers);
      }
    }
    EXPECT_EQ(found.facts.counts.vertices, expected.facts.counts.vertices);
    EXPECT_EQ(found.facts.counts.euler(), expected.facts.counts.euler());
  }
}

TEST(Sheets, OfAManifoldAreOne) {
  const Assembled found = assemble(voxel_solid({{1, 1, 1}, {1, 1, 2}}, 5));
  EXPECT_EQ(found.facts.counts.vertices, 12U);
  EXPECT_EQ(found.facts.counts.euler(), 2);
  for (const std::uint32_t sheet : found.chunks.at(0).sheets) EXPECT_EQ(sheet, 0U);
}

TEST(Sheets, TakeBodiesApartThatTouchAlongAnEdge) {
  const Assembled found = assemble(voxel_solid({{0, 0, 0}, {1, 1, 0}}, 4));
  EXPECT_EQ(found.facts.counts.vertices, 16U);
  EXPECT_EQ(found.facts.counts.euler(), 4);
  expect_manifold(stitched(found.chunks));
}

TEST(Sheets, TakeBodiesApartThatTouchInAPoint) {
  const Assembled found = assemble(voxel_solid({{0, 0, 0}, {1, 1, 1}}, 4));
  EXPECT_EQ(found.facts.counts.vertices, 16U);
  EXPECT_EQ(found.facts.counts.euler(), 4);
  expect_manifold(stitched(found.chunks));
}

TEST(Sheets, TakeABodyApartWhereItTouchesItself) {
  // Seven of the eight cubes of a ring: the first and the last touch along an edge.
  Voxels ring{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 1, 0}, {2, 2, 0}, {1, 2, 0}};
  const Assembled open = assemble(voxel_solid(ring, 5));
  EXPECT_EQ(open.facts.counts.euler(), 2);
  ring = {{1, 0, 0}, {2, 0, 0}, {2, 1, 0}, {2, 2, 0}, {1, 2, 0}, {0, 2, 0}, {0, 1, 0}};
  const Assembled touching = assemble(voxel_solid(ring, 5));
  EXPECT_EQ(touching.facts.counts.euler(), 2);
  expect_manifold(stitched(touching.chunks));
}

TEST(Sheets, TakeAPinchedTorusApart) {
  // A ring of ten cubes, two of which meet in a point where the ring is pinched.
  const Voxels ring{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}, {3, 1, 0}, {3, 2, 0},
                    {2, 2, 0}, {1, 2, 0}, {0, 1, 1}, {0, 2, 1}, {0, 2, 0}};
  const SheetOracle oracle = voxel_solid(ring, 6);
  const Assembled found = assemble(oracle);
  EXPECT_EQ(sheets_of(found.chunks), oracle.sheets());
  EXPECT_EQ(oracle.multiple_edges(), 1U);
  EXPECT_EQ(found.facts.counts.euler(), 2);
  expect_manifold(stitched(found.chunks));
}

TEST(Sheets, TakeCavitiesApartThatTouchAlongAnEdge) {
  // Inside, the body is in one piece around the edge: two wedges with the same ends.
  const SheetOracle oracle = voxel_solid(all_but({{1, 1, 1}, {2, 2, 1}}, 4), 5);
  EXPECT_EQ(oracle.multiple_edges(), 1U);
  EXPECT_EQ(oracle.turned_edges(), 1U);
  for (std::uint64_t points_per_chunk : {1, 20, 1000}) {
    const Assembled found = assemble(oracle, {.points_per_chunk = points_per_chunk});
    EXPECT_EQ(sheets_of(found.chunks), oracle.sheets());
    EXPECT_EQ(found.facts.counts.euler(), 6);
    expect_manifold(stitched(found.chunks));
  }
}

TEST(Sheets, TellFourFlatTrianglesInAPlaneApart) {
  // A board of cubes, black ones inside: at its inner edges triangles lie half a turn apart.
  Voxels black;
  for (int i = 0; i < 64; ++i) {
    if ((i % 4 + i / 4 % 4 + i / 16) % 2 == 0) black.insert({i % 4, i / 4 % 4, i / 16});
  }
  const SheetOracle oracle = voxel_solid(black, 5);
  const Assembled found = assemble(oracle, {.points_per_chunk = 9});
  EXPECT_EQ(sheets_of(found.chunks), oracle.sheets());
  const TestMesh mesh = stitched(found.chunks);
  expect_manifold(mesh);
  EXPECT_EQ(MeshOracle(mesh).facts().components, black.size());
  EXPECT_EQ(found.facts.counts.vertices, 8 * black.size());
}

/// The star of vertex 0: fans of so many triangles around it, one after the other.
std::vector<StarTriangle> fans(const std::vector<std::uint32_t>& sizes) {
  std::vector<StarTriangle> star;
  std::uint32_t first = 1;
  for (const std::uint32_t size : sizes) {
    for (std::uint32_t i = 0; i < size; ++i) {
      const auto [low, high] = std::minmax({first + i, first + (i + 1) % size});
      star.push_back({0, low, high, 1});
    }
    first += size;
  }
  std::sort(star.begin(), star.end());
  return star;
}

TEST(VertexSheets, AreTheFansOfTheStarHoweverLarge) {
  const RankedPoints nowhere({}, {});
  for (const std::vector<std::uint32_t>& sizes : std::vector<std::vector<std::uint32_t>>{
           {3}, {6}, {48}, {49}, {3000}, {3, 3}, {5, 40}, {300, 4, 500}}) {
    const auto star = fans(sizes);
    const VertexSheets sheets(star, nowhere);
    EXPECT_EQ(sheets.count(), sizes.size());
    EXPECT_EQ(sheets.sheets().front(), 0U);
    EXPECT_TRUE(sheets.touches().empty());
    EXPECT_EQ(is_closed_fan(star), sizes.size() == 1 && sizes[0] <= 48) << sizes[0];
  }
}

TEST(VertexSheets, OfAnOpenStarAreRefused) {
  auto star = fans({6});
  star.pop_back();
  EXPECT_FALSE(is_closed_fan(star));
  EXPECT_THROW(VertexSheets(star, RankedPoints({1, 5, 6}, std::vector<Point3>(3))),
               std::logic_error);
}

TEST(Sheets, OfASurfaceThatIsNotClosedAreRefused) {
  const SheetOracle oracle = voxel_solid({{0, 0, 0}, {1, 1, 0}}, 4);
  auto records = oracle.records();
  records.pop_back();
  Exported exported(oracle.points(), records, 1000);
  RecordingWriter keeper(false);
  EXPECT_THROW(exported.assemble(keeper), std::logic_error);
}

TEST(Sheets, OfMorePointsThanRanksOf32BitsAreRefused) {
  StageFixture stage;
  const ExportReader exports(stage.scratch, stage.budget);
  const ExportedFacets surface(exports, {std::uint64_t{1} << 32, (std::uint64_t{1} << 32) - 1});
  EXPECT_THROW(SurfaceSheets(surface, stage.context), InputError);
}

TEST(Sheets, MakeAnotherRun) {
  RunOptions options;
  options.inputs = {"-"};
  RunOptions split = options;
  split.manifold = true;
  const auto found = difference(identity_of(options), identity_of(split));
  ASSERT_TRUE(found.has_value());
  EXPECT_EQ(*found, "--manifold: nothing then, given now");
}

class MeshCollector : public MeshVisitor {
 public:
  void vertex(std::uint64_t number, const Point3& point) override { add(number, point); }
  void triangle(const MeshTriangle& t, const std::array<Point3, 3>& points) override {
    mesh.triangles.push_back({add(t[0], points[0]), add(t[1], points[1]), add(t[2], points[2])});
  }

  TestMesh mesh;

 private:
  std::uint32_t add(std::uint64_t number, const Point3& point) {
    const auto next = static_cast<std::uint32_t>(numbers_.size());
    const auto [at, is_new] = numbers_.try_emplace(number, next);
    if (is_new) mesh.points.push_back(point);
    return at->second;
  }

  std::map<std::uint64_t, std::uint32_t> numbers_;
};

TEST(Sheets, MakeManifoldFilesOfEveryFormat) {
  const SheetOracle oracle(random_points(400, 9), random_labels(0.5, 9));
  for (const char* name : {"out.ply", "out.vtk", "out.pvtp"}) {
    Exported exported(oracle.points(), oracle.records(), 50);
    const std::string path = exported.stage.folder.path() + "/" + name;
    const auto writer =
        make_surface_writer({.path = path, .scratch = &exported.stage.scratch, .has_sheets = true});
    const SurfaceFacts facts = exported.assemble(*writer);
    writer->finish();
    const auto source = open_mesh_source({.path = path, .scratch = &exported.stage.scratch});
    MeshCollector collector;
    source->read(collector);
    SCOPED_TRACE(name);
    expect_manifold(collector.mesh);
    expect_counts(facts, collector.mesh);
    EXPECT_EQ(collector.mesh.triangles.size(), oracle.sheets().size());
  }
}

}  // namespace
}  // namespace stream_recon
