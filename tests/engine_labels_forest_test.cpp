// The signed forest: contraction of a part changes no label of the whole.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <random>
#include <vector>

#include "engine/labels/evidence_sort.h"
#include "engine/labels/signed_forest.h"
#include "engine/windows/export_reader.h"
#include "tests/engine_fixture.h"
#include "tests/evidence_graphs.h"
#include "tests/evidence_windows.h"

namespace stream_recon {
namespace {

using evidence_graphs::random_graph;
using evidence_graphs::reference_labels;

constexpr std::uint64_t kSeeds = 30;

bool is_same(const EvidenceEdge& x, const EvidenceEdge& y) {
  return x.a == y.a && x.b == y.b && x.is_opposite == y.is_opposite && x.weight == y.weight &&
         x.tie == y.tie;
}

/// Random sizes, weights with many ties.
EvidenceGraphOptions options_of(std::uint64_t seed) {
  return {.nodes = static_cast<std::uint32_t>(200 + seed * 37 % 500),
          .edges = static_cast<std::uint32_t>(200 + seed * 211 % 2000),
          .weights = static_cast<std::uint32_t>(seed % 4 * 3),
          .infinite = static_cast<std::uint32_t>(seed % 5 * 20)};
}

std::vector<EvidenceEdge> random_edges(std::size_t count, std::uint32_t weights,
                                       std::mt19937_64& random) {
  std::vector<EvidenceEdge> edges(count);
  for (std::uint32_t i = 0; i < count; ++i) {
    const auto value = static_cast<std::uint32_t>(random());
    edges[i].a = i;
    edges[i].weight = static_cast<float>(weights == 0 ? value : value % weights) / 16;
    edges[i].tie = {value / 7 % 3, value % 11 == 0 ? value : 5, i};
  }
  std::shuffle(edges.begin(), edges.end(), random);
  return edges;
}

TEST(EvidenceSort, IsThatOfTheStandardLibraryWithAnyTies) {
  std::mt19937_64 random(7);
  for (const std::size_t count : {0, 1, 2, 48, 49, 1000, 100000}) {
    for (const std::uint32_t weights : {0U, 1U, 2U, 1000U}) {
      auto edges = random_edges(count, weights, random);
      auto expected = edges;
      std::sort(expected.begin(), expected.end(), comes_before);
      sort_evidence(edges);
      EXPECT_TRUE(std::equal(edges.begin(), edges.end(), expected.begin(), is_same))
          << count << " edges, " << weights << " weights";
    }
  }
}

TEST(EvidenceSort, PutsHeavyEdgesFirstWhateverTheirSize) {
  std::vector<EvidenceEdge> edges(200);
  for (std::size_t i = 0; i < edges.size(); ++i) {
    edges[i].weight = std::vector<float>{0, 1e-45F, -0.0F, 3e38F, 1}[i % 5];
    edges[i].tie = {static_cast<std::uint32_t>(i), 0, 0};
  }
  sort_evidence(edges);
  EXPECT_TRUE(std::is_sorted(edges.begin(), edges.end(), comes_before));
  EXPECT_EQ(edges.front().weight, 3e38F);
}

TEST(SignedForest, LabelsTheWholeGraphWhenOnlyTheInfiniteNodeIsBorder) {
  for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    std::mt19937_64 random(seed);
    const EvidenceGraph graph = random_graph(options_of(seed), random);
    const EvidenceWindow whole(graph, 0, graph.ranks);
    const Contraction contraction = contract(whole.border(graph), whole.edges);
    EXPECT_TRUE(contraction.edges.empty());
    const auto labels = reference_labels(graph);
    for (std::size_t i = 0; i < whole.nodes.size(); ++i) {
      const Attachment at = contraction.attachments[i];
      EXPECT_EQ(at.is_attached && at.is_opposite, labels[whole.nodes[i]]) << "node " << i;
    }
  }
}

TEST(SignedForest, KeepsLessThanAnEdgeABorderNodeInTheOrderOfTheForest) {
  for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    std::mt19937_64 random(seed);
    const EvidenceGraph graph = random_graph(options_of(seed), random);
    const EvidenceWindow window(graph, graph.ranks / 4, graph.ranks / 2);
    const NodeSet border = window.border(graph);
    const Contraction contraction = contract(border, window.edges);
    EXPECT_LT(contraction.edges.size(), border.count());
    EXPECT_TRUE(std::is_sorted(contraction.edges.begin(), contraction.edges.end(), comes_before));
    for (const EvidenceEdge& edge : contraction.edges) {
      EXPECT_TRUE(border.contains(edge.a) && border.contains(edge.b));
    }
  }
}

TEST(SignedForest, CountsNodesThatNoEvidenceLeadsTo) {
  NodeSet border(5);
  border.insert(4);
  border.number();
  const EvidenceEdge pair{.a = 0, .b = 1, .is_opposite = true, .weight = 1, .tie = {1, 0, 0}};
  const EvidenceEdge to_border{.a = 2, .b = 4, .is_opposite = true, .weight = 1, .tie = {2, 0, 0}};
  const Contraction contraction = contract(border, {pair, to_border});
  EXPECT_EQ(contraction.unattached, 3U);
  EXPECT_FALSE(contraction.attachments[1].is_attached);
  EXPECT_EQ(contraction.attachments[2], (Attachment{4, true, true}));
  EXPECT_EQ(contraction.attachments[4], (Attachment{4, true, false}));
}

TEST(SignedForest, TakesTheHeavierOfTwoContradictingPaths) {
  NodeSet border(3);
  border.insert(0);
  border.number();
  // 2 is on the side of 0 by the weak edge, on the other one by the two strong ones.
  const EvidenceEdge weak{.a = 0, .b = 2, .weight = 1, .tie = {1, 0, 0}};
  const EvidenceEdge strong{.a = 0, .b = 1, .is_opposite = true, .weight = 2, .tie = {2, 0, 0}};
  const EvidenceEdge same{.a = 1, .b = 2, .weight = 2, .tie = {3, 0, 0}};
  const Contraction contraction = contract(border, {weak, strong, same});
  EXPECT_EQ(contraction.attachments[2], (Attachment{0, true, true}));
}

TEST(EvidenceExport, KeepsATableAndAListInTheirOrders) {
  std::mt19937_64 random(3);
  const EvidenceGraph graph = random_graph({}, random);
  StageFixture stage;
  const EvidenceWindow window(graph, 48, 96);
  const Contraction contraction = export_window(graph, window, stage.scratch);

  const ExportReader reader(stage.scratch, stage.budget);
  const auto keys =
      ExportedRecords<NodeKey>(reader, ExportKind::kEvidenceNodes).records(window.first);
  const auto edges =
      ExportedRecords<EvidenceEdge>(reader, ExportKind::kEvidenceEdges).records(window.first);
  auto expected = window.border_keys(graph);
  std::sort(expected.begin(), expected.end());
  EXPECT_EQ(keys, expected);
  EXPECT_TRUE(std::equal(edges.begin(), edges.end(), contraction.edges.begin(),
                         contraction.edges.end(), is_same));
  EXPECT_TRUE(std::is_sorted(edges.begin(), edges.end(), comes_before));
  for (std::size_t i = 0; i < window.nodes.size(); ++i) {
    const NodeKey& key = graph.nodes[window.nodes[i]];
    if (!window.is_border(key)) continue;
    ASSERT_TRUE(contraction.attachments[i].is_attached);
    EXPECT_EQ(keys[contraction.attachments[i].node], key);
  }
}

TEST(EvidenceExport, HasTheSignInTheTopBitOfTheSecondNode) {
  const EvidenceEdge edge{.a = 1, .b = 2, .is_opposite = true};
  const auto words = std::bit_cast<std::array<std::uint32_t, 6>>(edge);
  EXPECT_EQ(words[1], 0x80000002);
}

}  // namespace
}  // namespace stream_recon
