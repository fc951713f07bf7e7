// The hybrid of a run: the gamma facets that bound the solid, patches without cracks or new
// vertices, and the same bytes however the run is cut. And how its holes are found.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <map>
#include <numbers>
#include <optional>
#include <ostream>
#include <random>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "engine/hybrid/hole_group.h"
#include "engine/hybrid/hole_samples.h"
#include "engine/hybrid/hole_search.h"
#include "engine/hybrid/stored_hole.h"
#include "engine/labels/facet_labels.h"
#include "engine/order/point_store.h"
#include "engine/reconstruct.h"
#include "io/mesh_source.h"
#include "spatial/vector.h"
#include "tests/engine_fixture.h"
#include "tests/full_disks.h"
#include "tests/io_test_folder.h"
#include "tests/point_families.h"

namespace stream_recon {
namespace {

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool kIsSlow = true;  // each takes ten times as long
#else
constexpr bool kIsSlow = false;
#endif

using Cloud = std::vector<Point3>;
using Ranks = std::array<std::uint32_t, 3>;

// ---- The search for holes.

/// Distinct triangles over so many points, some of which share edges.
std::vector<Ranks> random_fills(std::mt19937_64& random, std::uint32_t points, std::size_t count) {
  std::set<Ranks> fills;
  std::uniform_int_distribution<std::uint32_t> rank(0, points - 1);
  while (fills.size() < count) {
    const std::uint32_t low = rank(random);
    Ranks ranks{low, std::min(low + 1 + rank(random) % 3, points - 1), rank(random)};
    std::sort(ranks.begin(), ranks.end());
    if (ranks[0] != ranks[1] && ranks[1] != ranks[2]) fills.insert(ranks);
  }
  return {fills.begin(), fills.end()};
}

/// As label_facets() sets them apart, in several files and any order.
void set_apart(StageFixture& stage, std::vector<Ranks> fills, std::mt19937_64& random) {
  std::shuffle(fills.begin(), fills.end(), random);
  constexpr std::size_t kFiles = 3;
  for (std::size_t file = 0; file < kFiles; ++file) {
    auto out = create_records<FacetRecord>(stage.scratch, export_name(file * 1000, kFillsPrefix),
                                           kFillsBlock);
    for (std::size_t i = file; i < fills.size(); i += kFiles) {
      FacetRecord facet{.ranks = {fills[i][0], fills[i][1], fills[i][2]},
                        .delta = static_cast<float>(fills[i][0]),
                        .source = TriangleSource::kFill,
                        .facing = fills[i][0] % 2 == 0 ? Facing::kOutward : Facing::kInward,
                        .closure = 7};
      out.append(facet);
    }
    out.finish();
  }
}

Point3 point_of(std::uint32_t rank) {
  return {1.0 * rank, 0.5 * rank * rank, -1.0 * rank};
}

void store_points(StageFixture& stage, std::uint32_t count) {
  auto out = create_records<StoredPoint>(stage.scratch, kPointStore, kPointStoreBlock);
  for (std::uint32_t rank = 0; rank < count; ++rank) out.append({point_of(rank), rank});
  out.finish();
}

/// Joined at edges by going round until nothing changes.
std::set<std::set<Ranks>> pieces_of(const std::vector<Ranks>& fills) {
  std::vector<std::size_t> piece(fills.size());
  for (std::size_t i = 0; i < fills.size(); ++i) piece[i] = i;
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<std::size_t>> edges;
  for (std::size_t i = 0; i < fills.size(); ++i) {
    const auto& r = fills[i];
    for (const auto& [a, b] : {std::pair{r[0], r[1]}, {r[0], r[2]}, {r[1], r[2]}}) {
      edges[{a, b}].push_back(i);
    }
  }
  for (bool changes = true; changes;) {
    changes = false;
    for (const auto& [edge, users] : edges) {
      for (const std::size_t i : users) {
        const std::size_t least = std::min(piece[i], piece[users[0]]);
        changes = changes || piece[i] != least || piece[users[0]] != least;
        piece[i] = piece[users[0]] = least;
      }
    }
  }
  std::map<std::size_t, std::set<Ranks>> by_piece;
  for (std::size_t i = 0; i < fills.size(); ++i) by_piece[piece[i]].insert(fills[i]);
  std::set<std::set<Ranks>> pieces;
  for (const auto& [number, members] : by_piece) pieces.insert(members);
  return pieces;
}

TEST(HoleSearch, JoinsFillsAtEdgesAsGoingRoundDoesInAnyMemory) {
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const std::uint32_t points = 40U << seed;
    for (const std::uint64_t memory : {std::uint64_t{1} << 30, std::uint64_t{24} << 20}) {
      std::mt19937_64 random(seed);
      const std::vector<Ranks> fills = random_fills(random, points, std::size_t{30} << seed);
      StageFixture stage(memory);
      store_points(stage, points);
      set_apart(stage, fills, random);
      const HoleCounts counts = find_holes(stage.context);
      EXPECT_EQ(counts.fills, fills.size());

      std::set<std::set<Ranks>> found;
      HoleReader reader(stage.scratch, false);
      std::optional<Ranks> last;
      for (std::uint32_t number = 0; reader.next(); ++number) {
        const StoredHole hole = reader.read();
        EXPECT_EQ(hole.number, number);
        std::set<Ranks> members;
        for (std::size_t i = 0; i < hole.records.size(); ++i) {
          members.insert(hole.records[i].ranks);
          EXPECT_EQ(hole.records[i].delta, static_cast<float>(hole.records[i].ranks[0]));
          EXPECT_EQ(hole.records[i].closure, 7);
          Ranks corners{};
          for (int k = 0; k < 3; ++k) corners[k] = hole.ranks[hole.hole.fills[i][k]];
          Ranks expected = hole.records[i].ranks;
          if (expected[0] % 2 == 1) std::swap(expected[1], expected[2]);
          EXPECT_EQ(corners, expected);
        }
        // Holes stand in the order of their lowest fills.
        EXPECT_TRUE(!last || *last < hole.records[0].ranks);
        last = hole.records[0].ranks;
        for (std::size_t i = 0; i < hole.ranks.size(); ++i) {
          EXPECT_EQ(hole.hole.points[i], point_of(hole.ranks[i]));
        }
        found.insert(members);
      }
      EXPECT_EQ(found, pieces_of(fills));
      EXPECT_EQ(counts.holes, found.size());
    }
  }
}

TEST(HoleSearch, OfNoFillsFindsNoHole) {
  StageFixture stage;
  store_points(stage, 5);
  EXPECT_EQ(find_holes(stage.context).holes, 0U);
  HoleReader reader(stage.scratch, false);
  EXPECT_FALSE(reader.next().has_value());
}

TEST(HoleSamples, TellTheHolesOfASample) {
  MemoryBudget budget(1 << 20);
  HoleSamples samples(100, budget);
  samples.add(std::vector<std::uint32_t>{5, 9, 70}, 3);
  samples.add(std::vector<std::uint32_t>{9, 10}, 4);
  samples.add(std::vector<std::uint32_t>{9, 99}, 8);
  samples.finish();
  const auto holes = [&](std::uint32_t rank) {
    std::vector<std::uint32_t> numbers;
    for (const HoleSample& at : samples.of(rank)) numbers.push_back(at.hole);
    return numbers;
  };
  EXPECT_EQ(holes(9), (std::vector<std::uint32_t>{3, 4, 8}));
  EXPECT_EQ(holes(70), (std::vector<std::uint32_t>{3}));
  EXPECT_EQ(holes(71), (std::vector<std::uint32_t>{}));
  EXPECT_TRUE(samples.choice().has(99));
  EXPECT_FALSE(samples.choice().has(98));
  EXPECT_GT(budget.used(), 7 * sizeof(HoleSample));
}

// ---- Whole runs.

std::string write_cloud(const TestFolder& folder, const Cloud& cloud) {
  put_bytes(folder / "cloud.f64",
            {reinterpret_cast<const char*>(cloud.data()), cloud.size() * sizeof(Point3)});
  return folder / "cloud.f64";
}

RunOptions options_for(const TestFolder& folder, const Cloud& cloud) {
  RunOptions options;
  options.inputs = {write_cloud(folder, cloud)};
  options.input_format = InputFormat::kF64;
  options.surface = SurfaceKind::kHybrid;
  options.output = folder / "out.pvtp";
  options.memory_bytes = std::uint64_t{512} << 20;
  options.threads = 1;
  options.chunk_points = 700;
  return options;
}

std::string output_bytes(const TestFolder& folder) {
  std::string all = file_bytes(folder / "out.pvtp");
  for (const std::string& chunk : list_folder(folder / "out")) {
    all += chunk + file_bytes(folder / ("out/" + chunk));
  }
  return all;
}

Point3 direction(std::mt19937_64& random) {
  for (;;) {
    const Point3 p = families::random_point(random);
    const double size = length(p);
    if (size > 0.01 && size <= 1) return scaled(p, 1 / size);
  }
}

/// A ball with bumps, sampled so thinly that the gamma shape has holes.
Cloud bumpy(std::size_t count, double depth = 0.45) {
  std::mt19937_64 random(41);
  Cloud cloud;
  while (cloud.size() < count) {
    const Point3 d = direction(random);
    cloud.push_back(scaled(d, 1 + depth * std::sin(5 * d.x) * std::cos(4 * d.y)));
  }
  return cloud;
}

/// The same with bare patches, whose holes are large.
Cloud patchy(std::size_t count) {
  std::mt19937_64 random(43);
  const Point3 first = direction(random);
  const std::array<Point3, 2> bare{first, scaled(first, -1)};
  Cloud cloud;
  std::uniform_real_distribution<double> chance(0, 1);
  for (const Point3& p : bumpy(count, 0.15)) {
    const Point3 d = scaled(p, 1 / length(p));
    const bool is_bare =
        std::any_of(bare.begin(), bare.end(), [&](const Point3& b) { return dot(b, d) > 0.8; });
    if (!is_bare || chance(random) < 0.02) cloud.push_back(p);
  }
  return cloud;
}

/// With samples off the surface, on one side of it.
Cloud noise(std::size_t count) {
  std::mt19937_64 random(47);
  std::normal_distribution<double> off(1, 0.02);
  Cloud cloud;
  for (const Point3& p : bumpy(count, 0.2)) cloud.push_back(p.x > 0.5 ? scaled(p, off(random)) : p);
  return cloud;
}

/// Boundary voxels of two balls that touch.
Cloud voxels(int radius) {
  const auto contains = [radius](int x, int y, int z) {
    const int a = x * x + y * y + z * z;
    const int b = (x - 2 * radius + 1) * (x - 2 * radius + 1) + y * y + z * z;
    return std::min(a, b) < radius * radius;
  };
  Cloud cloud;
  for (int z = -radius; z <= radius; ++z) {
    for (int y = -radius; y <= radius; ++y) {
      for (int x = -radius; x <= 3 * radius; ++x) {
        const bool is_inner = contains(x + 1, y, z) && contains(x - 1, y, z) &&
                              contains(x, y + 1, z) && contains(x, y - 1, z) &&
                              contains(x, y, z + 1) && contains(x, y, z - 1);
        if (contains(x, y, z) && !is_inner) cloud.push_back({1.0 * x, 1.0 * y, 1.0 * z});
      }
    }
  }
  return cloud;
}

/// The triangles of a chunked surface, by input index.
struct Mesh : MeshVisitor {
  explicit Mesh(const std::string& path) { open_mesh_source({.path = path})->read(*this); }

  void vertex(std::uint64_t number, const Point3& point) override {
    points.try_emplace(number, point);
  }
  void triangle(const MeshTriangle& corners, const std::array<Point3, 3>& /*places*/) override {
    MeshTriangle turned = corners;
    std::rotate(turned.begin(), std::min_element(turned.begin(), turned.end()), turned.end());
    EXPECT_TRUE(triangles.insert(turned).second) << "a triangle twice";
  }

  /// How much more often each edge is run along one way than the other; only those that are.
  std::map<std::pair<std::uint64_t, std::uint64_t>, int> open_edges() const {
    std::map<std::pair<std::uint64_t, std::uint64_t>, int> balance;
    for (const MeshTriangle& t : triangles) {
      for (int i = 0; i < 3; ++i) {
        const std::uint64_t a = t[i];
        const std::uint64_t b = t[(i + 1) % 3];
        balance[{std::min(a, b), std::max(a, b)}] += a < b ? 1 : -1;
      }
    }
    std::erase_if(balance, [](const auto& edge) { return edge.second == 0; });
    return balance;
  }

  std::map<std::uint64_t, Point3> points;
  std::set<MeshTriangle> triangles;
};

struct Shape {
  std::string name;
  std::function<Cloud()> make;
};

void PrintTo(const Shape& shape, std::ostream* out) {
  *out << shape.name;
}

constexpr std::size_t kPoints = kIsSlow ? 700 : 3000;

std::vector<Shape> shapes() {
  return {{"bumpy", [] { return bumpy(kPoints); }},
          {"patchy", [] { return patchy(kPoints); }},
          {"voxels", [] { return voxels(7); }},
          {"noise", [] { return noise(kPoints); }}};
}

class HybridOf : public testing::TestWithParam<Shape> {};

TEST_P(HybridOf, HasTheGammaFacetsOfTheSolidAndPatchesBetweenSamples) {
  const TestFolder folder;
  const Cloud cloud = GetParam().make();
  RunOptions options = options_for(folder, cloud);
  const Report report = reconstruct(options);
  const Mesh hybrid(folder / "out.pvtp");
  ASSERT_TRUE(report.hybrid.has_value());
  const HybridReport& holes = *report.hybrid;
  EXPECT_GT(holes.holes, 5U);
  EXPECT_EQ(holes.holes, holes.by_triangles + holes.by_crust + holes.left_out);
  EXPECT_EQ(holes.by_solid, 0U);
  EXPECT_EQ(hybrid.triangles.size(), report.surface.triangles);
  for (const auto& [number, point] : hybrid.points) {
    ASSERT_LT(number, cloud.size());
    EXPECT_EQ(point, cloud[number]);
  }
  EXPECT_EQ(hybrid.open_edges().empty(), holes.left_out == 0);

  options.fills_with_solid = true;
  const Report filled_report = reconstruct(options);
  const Mesh filled(folder / "out.pvtp");
  EXPECT_TRUE(filled.open_edges().empty());
  EXPECT_EQ(filled_report.surface.boundary_edges, 0U);
  EXPECT_EQ(filled_report.hybrid->by_solid, holes.left_out);
  EXPECT_TRUE(std::includes(filled.triangles.begin(), filled.triangles.end(),
                            hybrid.triangles.begin(), hybrid.triangles.end()));
}

TEST_P(HybridOf, IsTheSameBytesForAnyWindowsThreadsAndMemory) {
  const TestFolder folder;
  RunOptions options = options_for(folder, GetParam().make());
  const Report first = reconstruct(options);
  const std::string expected = output_bytes(folder);
  struct How {
    std::uint64_t window_points;
    unsigned threads;
    std::uint64_t memory = std::uint64_t{512} << 20;
  };
  std::vector<How> ways{{160, 3}};
  if (!kIsSlow) ways.insert(ways.end(), {{48, 3}, {500, 1}, {0, 3}, {0, 1, kLeastMemory}});
  for (const How& how : ways) {
    SCOPED_TRACE(std::to_string(how.window_points) + " points, threads " +
                 std::to_string(how.threads));
    options.window_points = how.window_points;
    options.threads = how.threads;
    options.memory_bytes = how.memory;
    const Report report = reconstruct(options);
    EXPECT_EQ(report.surface.digest, first.surface.digest);
    EXPECT_EQ(report.hybrid->by_crust, first.hybrid->by_crust);
    EXPECT_TRUE(output_bytes(folder) == expected);
  }
}

INSTANTIATE_TEST_SUITE_P(Clouds, HybridOf, testing::ValuesIn(shapes()),
                         [](const auto& test) { return test.param.name; });

TEST(HybridOfNoise, ClosesLargeHolesByTheCrust) {
  const TestFolder folder;
  const Report report = reconstruct(options_for(folder, noise(kPoints)));
  EXPECT_GT(report.hybrid->by_crust, 0U);
  EXPECT_GT(report.power->poles, 0U);
  // Only those at holes.
  EXPECT_LT(report.power->poles, report.poles->inner);
}

TEST(HybridRun, GoesOnAfterAFullDiskToTheSameBytes) {
  const TestFolder folder;
  RunOptions options = options_for(folder, patchy(500));
  options.window_points = 160;
  const int failures = expect_same_after_full_disks(options, folder, kIsSlow ? 60 : 31,
                                                    [&] { return output_bytes(folder); });
  EXPECT_GT(failures, 1);
}

}  // namespace
}  // namespace stream_recon
