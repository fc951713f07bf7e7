// From facets to chunks: counts against brute force, numbers, orientation, independence of order.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>
#include <numeric>
#include <random>
#include <set>
#include <utility>
#include <vector>

#include "engine/order/point_store.h"
#include "engine/scratch_records.h"
#include "engine/surface/assembly.h"
#include "engine/surface/edge_uses.h"
#include "engine/surface/orientation.h"
#include "tests/engine_fixture.h"
#include "tests/recording_writer.h"

namespace stream_recon {
namespace {

using Ranks = std::array<PointRank, 3>;

/// A point whose coordinates tell its rank; its input index is ten times the rank.
StoredPoint point_of(PointRank rank) {
  const auto x = static_cast<double>(rank);
  return {{x, -x, 2 * x}, 10 * rank};
}

struct Assembled {
  SurfaceCounts counts;
  std::vector<SurfaceChunk> chunks;
  std::uint64_t components = 0;
};

struct AssemblyCase {
  bool in_order = true;
  std::uint64_t memory = std::uint64_t{1} << 30;  ///< for the assembly
};

Assembled assemble(const std::vector<Ranks>& facets, const ChunkLayout& layout, std::uint64_t seed,
                   const AssemblyCase& how = {}) {
  StageFixture stage;
  auto store = create_records<StoredPoint>(stage.scratch, kPointStore, kPointStoreBlock);
  for (PointRank rank = 0; rank < layout.point_count; ++rank) store.append(point_of(rank));
  store.finish();

  std::vector<FacetRecord> records;
  records.reserve(facets.size());
  for (const Ranks& ranks : facets) {
    records.push_back({ranks, static_cast<float>(ranks[0] % 90), TriangleSource::kGamma});
  }
  std::shuffle(records.begin(), records.end(), std::mt19937_64(seed));
  ExportWriter out(stage.scratch, 0);
  export_facets(records, layout, out);
  out.finish();
  const ExportReader exports(stage.scratch, stage.budget);
  const Reservation others =
      stage.budget.reserve(stage.budget.available() - how.memory, "everything else");
  RecordingWriter writer(how.in_order);
  const SurfaceFacts facts = assemble_surface({exports, layout}, writer, stage.context, {});
  EXPECT_GT(stage.budget.peak(), 0U);
  EXPECT_FALSE(facts.genus || facts.volume) << "nothing says that it bounds a solid";
  return {facts.counts, writer.chunks, facts.components};
}

std::vector<Ranks> random_facets(std::size_t count, PointRank points, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::set<Ranks> facets;
  while (facets.size() < count) {
    // Near neighbours mostly, as on a Hilbert curve, some far.
    const PointRank reach = random() % 5 == 0 ? points : 6;
    Ranks ranks;
    ranks[0] = random() % points;
    for (int i : {1, 2}) ranks[i] = std::min(points - 1, ranks[0] + random() % reach);
    std::sort(ranks.begin(), ranks.end());
    if (ranks[0] != ranks[1] && ranks[1] != ranks[2]) facets.insert(ranks);
  }
  return {facets.begin(), facets.end()};
}

TEST(Assembly, CountsAgreeWithBruteForceHoweverTheCloudIsChunked) {
  const std::vector<Ranks> facets = random_facets(3000, 900, 5);
  std::map<std::pair<PointRank, PointRank>, int> edges;
  std::set<PointRank> vertices;
  SimplexDigest digest;
  for (const Ranks& f : facets) {
    vertices.insert(f.begin(), f.end());
    for (const auto& [a, b] : {std::pair(0, 1), std::pair(0, 2), std::pair(1, 2)}) {
      ++edges[{f[a], f[b]}];
    }
    digest.add<3>({10 * f[0], 10 * f[1], 10 * f[2]});
  }
  const auto with = [&edges](auto condition) {
    return static_cast<std::uint64_t>(std::count_if(
        edges.begin(), edges.end(), [&](const auto& edge) { return condition(edge.second); }));
  };
  for (std::uint64_t points_per_chunk : {1, 7, 100, 899, 900, 5000}) {
    const SurfaceCounts counts = assemble(facets, {points_per_chunk, 900}, 1).counts;
    EXPECT_EQ(counts.triangles, facets.size()) << points_per_chunk;
    EXPECT_EQ(counts.vertices, vertices.size()) << points_per_chunk;
    EXPECT_EQ(counts.edges, edges.size()) << points_per_chunk;
    EXPECT_EQ(counts.boundary_edges, with([](int uses) { return uses == 1; }));
    EXPECT_EQ(counts.nonmanifold_edges, with([](int uses) { return uses > 2; }));
    EXPECT_EQ(counts.digest.hex(), digest.hex());
  }
}

TEST(Assembly, ComponentsAreWhatHangsTogetherAtEdgesAcrossChunks) {
  for (const std::size_t count : {20, 150, 400}) {
    const std::vector<Ranks> facets = random_facets(count, 300, 7);
    std::map<std::pair<PointRank, PointRank>, std::vector<std::uint32_t>> edges;
    for (std::uint32_t f = 0; f < facets.size(); ++f) {
      for (const auto& [a, b] : {std::pair(0, 1), std::pair(0, 2), std::pair(1, 2)}) {
        edges[{facets[f][a], facets[f][b]}].push_back(f);
      }
    }
    std::vector<std::uint32_t> label(facets.size());
    std::iota(label.begin(), label.end(), 0U);
    for (bool has_changed = true; has_changed;) {
      has_changed = false;
      for (const auto& [edge, users] : edges) {
        for (const std::uint32_t a : users) {
          for (const std::uint32_t b : users) {
            if (label[a] <= label[b]) continue;
            label[a] = label[b];
            has_changed = true;
          }
        }
      }
    }
    const std::set<std::uint32_t> components(label.begin(), label.end());
    EXPECT_GT(components.size(), 2U);
    for (std::uint64_t points_per_chunk : {1, 7, 40, 299, 300}) {
      EXPECT_EQ(assemble(facets, {points_per_chunk, 300}, 1).components, components.size());
    }
  }
}

TEST(Assembly, ChunksHoldTheFacetsOfTheirPointsWithBitEqualCorners) {
  const std::vector<Ranks> facets = random_facets(2000, 500, 6);
  const auto assembled = assemble(facets, {50, 500}, 1);
  std::vector<Ranks> found;
  for (const SurfaceChunk& chunk : assembled.chunks) {
    std::set<std::uint64_t> owners;
    for (std::size_t t = 0; t < chunk.triangles.size(); ++t) {
      Ranks ranks;
      for (int i = 0; i < 3; ++i) {
        const std::uint32_t v = chunk.triangles[t][i];
        ranks[i] = chunk.global_ids[v] / 10;
        EXPECT_EQ(chunk.points[v], point_of(ranks[i]).point);
      }
      std::sort(ranks.begin(), ranks.end());
      EXPECT_EQ(chunk.delta[t], static_cast<float>(ranks[0] % 90));
      owners.insert(ranks[0] / 50);
      found.push_back(ranks);
    }
    EXPECT_EQ(owners.size(), 1U);
  }
  EXPECT_TRUE(std::is_sorted(found.begin(), found.end()));
  EXPECT_EQ(found, facets);
}

TEST(Assembly, NumbersVerticesInTheOrderOfFirstAppearance) {
  for (std::uint64_t points_per_chunk : {1, 3, 40, 300}) {
    const auto assembled = assemble(random_facets(900, 300, 8), {points_per_chunk, 300}, 1);
    std::map<std::uint64_t, std::uint64_t> number_of;  // by global id
    for (const SurfaceChunk& chunk : assembled.chunks) {
      for (std::size_t v = 0; v < chunk.points.size(); ++v) {
        const auto [at, is_new] = number_of.try_emplace(chunk.global_ids[v], number_of.size());
        EXPECT_EQ(chunk.vertex_numbers[v], at->second)
            << (is_new ? "new" : "known") << " vertex, chunks of " << points_per_chunk;
      }
    }
    EXPECT_EQ(assembled.counts.vertices, number_of.size());
  }
}

TEST(Assembly, DoesNotDependOnTheOrderOfTheFacets) {
  const std::vector<Ranks> facets = random_facets(2000, 500, 9);
  const auto one = assemble(facets, {64, 500}, 1);
  const auto two = assemble(facets, {64, 500}, 2);
  ASSERT_EQ(one.chunks.size(), two.chunks.size());
  for (std::size_t c = 0; c < one.chunks.size(); ++c) {
    EXPECT_EQ(one.chunks[c].triangles, two.chunks[c].triangles);
    EXPECT_EQ(one.chunks[c].global_ids, two.chunks[c].global_ids);
    EXPECT_EQ(one.chunks[c].vertex_numbers, two.chunks[c].vertex_numbers);
  }
}

TEST(Assembly, ChunksAreTheSameSideBySideAndInLittleMemory) {
  const std::vector<Ranks> facets = random_facets(9000, 3000, 10);
  const ChunkLayout layout{100, 3000};
  const auto expected = assemble(facets, layout, 1);
  // A chunk takes 6 MB, its pieces 2, and handing numbers from chunk to chunk 12.
  const AssemblyCase side_by_side{.in_order = false};
  const AssemblyCase one_by_one{.in_order = false, .memory = std::uint64_t{8} << 20};
  const AssemblyCase in_little{.in_order = true, .memory = std::uint64_t{18} << 20};
  for (const AssemblyCase& how : {side_by_side, one_by_one, in_little}) {
    const auto found = assemble(facets, layout, 2, how);
    EXPECT_EQ(found.counts.vertices, expected.counts.vertices);
    EXPECT_EQ(found.components, expected.components);
    EXPECT_EQ(found.counts.edges, expected.counts.edges);
    EXPECT_EQ(found.counts.digest.hex(), expected.counts.digest.hex());
    ASSERT_EQ(found.chunks.size(), expected.chunks.size());
    for (std::size_t c = 0; c < found.chunks.size(); ++c) {
      EXPECT_EQ(found.chunks[c].triangles, expected.chunks[c].triangles);
      EXPECT_EQ(found.chunks[c].delta, expected.chunks[c].delta);
      EXPECT_EQ(found.chunks[c].points, expected.chunks[c].points);
      EXPECT_EQ(found.chunks[c].global_ids, expected.chunks[c].global_ids);
      if (how.in_order) {
        EXPECT_EQ(found.chunks[c].vertex_numbers, expected.chunks[c].vertex_numbers);
      }
    }
  }
}

TEST(Assembly, LeavesNoGapInTheNumbersOfChunks) {
  const std::vector<Ranks> facets{{0, 1, 2}, {0, 1, 55}, {70, 71, 99}};
  const auto [counts, chunks, components] = assemble(facets, {10, 100}, 1, {false});
  EXPECT_EQ(components, 2U);
  ASSERT_EQ(chunks.size(), 2U);
  EXPECT_EQ(chunks[0].triangles.size(), 2U);
  EXPECT_EQ(chunks[1].triangles.size(), 1U);
  EXPECT_EQ(counts.vertices, 7U);
}

TEST(Assembly, OfNoFacetsIsNothing) {
  const auto [counts, chunks, components] = assemble({}, {10, 100}, 1);
  EXPECT_EQ(components, 0U);
  EXPECT_EQ(counts.vertices, 0U);
  EXPECT_EQ(counts.euler(), 0);
  EXPECT_TRUE(chunks.empty());
}

/// Directed edges that two triangles share in the same direction: disagreements.
int disagreements(std::vector<LocalTriangle> triangles, const std::vector<bool>& reversed) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> directed;
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    auto& v = triangles[t];
    if (reversed[t]) std::swap(v[1], v[2]);
    for (int i = 0; i < 3; ++i) ++directed[{v[i], v[(i + 1) % 3]}];
  }
  return static_cast<int>(
      std::count_if(directed.begin(), directed.end(), [](const auto& e) { return e.second > 1; }));
}

TEST(Orientation, NeighboursAgreeOnATwoSidedSurface) {
  // A torus of 12 x 9 vertices, two triangles a square.
  std::vector<LocalTriangle> triangles;
  const auto vertex = [](std::uint32_t i, std::uint32_t j) { return i % 12 * 9 + j % 9; };
  for (std::uint32_t i = 0; i < 12; ++i) {
    for (std::uint32_t j = 0; j < 9; ++j) {
      triangles.push_back({vertex(i, j), vertex(i + 1, j), vertex(i, j + 1)});
      triangles.push_back({vertex(i + 1, j), vertex(i + 1, j + 1), vertex(i, j + 1)});
    }
  }
  for (LocalTriangle& t : triangles) std::sort(t.begin(), t.end());
  std::sort(triangles.begin(), triangles.end());
  const std::vector<Facing> unknown(triangles.size(), Facing::kUnknown);
  const auto uses = sorted_edge_uses(triangles);
  EXPECT_EQ(uses.size(), 3 * triangles.size());
  const auto reversed = orient(uses, unknown).reversed;
  EXPECT_EQ(disagreements(triangles, reversed), 0);
  EXPECT_FALSE(reversed[0]);
}

TEST(Orientation, AMoebiusStripDisagreesAndDoesNotHang) {
  const std::uint32_t n = 9;
  std::vector<LocalTriangle> triangles;
  for (std::uint32_t i = 0; i < n; ++i) triangles.push_back({i, (i + 1) % n, (i + 2) % n});
  for (LocalTriangle& t : triangles) std::sort(t.begin(), t.end());
  const auto reversed =
      orient(sorted_edge_uses(triangles), std::vector<Facing>(triangles.size(), Facing::kUnknown))
          .reversed;
  EXPECT_EQ(disagreements(triangles, reversed), 1);
}

TEST(Orientation, HullFacetsTurnTheirComponentOutward) {
  // The four faces of a tetrahedron whose vertices 0 1 2 run counterclockwise seen from 3.
  const std::vector<LocalTriangle> triangles{{0, 1, 2}, {0, 1, 3}, {0, 2, 3}, {1, 2, 3}};
  const auto uses = sorted_edge_uses(triangles);
  const auto facing_of_first = [&](Facing facing) {
    return orient(uses,
                  std::vector<Facing>{facing, Facing::kUnknown, Facing::kUnknown, Facing::kUnknown})
        .reversed;
  };
  EXPECT_EQ(facing_of_first(Facing::kInward), (std::vector<bool>{true, false, true, false}));
  EXPECT_EQ(facing_of_first(Facing::kOutward), (std::vector<bool>{false, true, false, true}));
  EXPECT_EQ(facing_of_first(Facing::kUnknown), facing_of_first(Facing::kOutward));
}

}  // namespace
}  // namespace stream_recon
