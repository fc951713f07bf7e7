// The forest of the whole cloud from what its windows hand on: labels do not depend on the cut, the
// levels or the memory.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <fstream>
#include <limits>
#include <random>
#include <set>
#include <string>
#include <vector>

#include "engine/labels/forest_merge.h"
#include "engine/labels/join_plan.h"
#include "engine/labels/part_join.h"
#include "engine/parallel.h"
#include "io/error.h"
#include "tests/engine_fixture.h"
#include "tests/evidence_graphs.h"
#include "tests/evidence_windows.h"

namespace stream_recon {
namespace {

using evidence_graphs::random_graph;
using evidence_graphs::reference_labels;
using testing::HasSubstr;

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr std::uint64_t kSeeds = 12;  // each takes ten times as long
#else
constexpr std::uint64_t kSeeds = 60;
#endif
constexpr std::uint64_t kUnlimited = std::numeric_limits<std::uint64_t>::max();

/// Holds the streams of so many parts of a small graph, and the list of the windows.
std::uint64_t budget_for(std::uint64_t parts) {
  return join_memory({.parts = parts, .nodes = 0}) + (std::uint64_t{96} << 10);
}

struct Exported {
  Exported(const EvidenceGraph& g, const std::vector<std::uint32_t>& cuts, StageFixture& s)
      : graph(g), stage(s) {
    for (std::size_t i = 1; i < cuts.size(); ++i) {
      windows.emplace_back(graph, cuts[i - 1], cuts[i]);
      // Without evidence nothing is handed on.
      if (windows.back().edges.empty()) {
        windows.pop_back();
        continue;
      }
      contractions.push_back(export_window(graph, windows.back(), stage.scratch));
    }
  }

  MergedForest merge() const {
    const ExportReader reader(stage.scratch, stage.budget);
    return merge_forest(reader, stage.context);
  }

  void expect_labels(const MergedForest& forest) const {
    const auto expected = reference_labels(graph);
    for (std::size_t w = 0; w < windows.size(); ++w) {
      const NodeLabels labels = forest.labels.labels(windows[w].first);
      const auto& attachments = contractions[w].attachments;
      for (std::size_t i = 0; i < attachments.size(); ++i) {
        const NodeLabel label = labels.label(attachments[i]);
        ASSERT_EQ(label == NodeLabel::kInside, expected[windows[w].nodes[i]])
            << "window " << w << ", node " << windows[w].nodes[i];
      }
    }
  }

  /// Nodes that windows handed on.
  std::set<NodeKey> border() const {
    std::set<NodeKey> nodes;
    for (const EvidenceWindow& window : windows) {
      const auto keys = window.border_keys(graph);
      nodes.insert(keys.begin(), keys.end());
    }
    return nodes;
  }
  std::uint64_t edges() const {
    std::uint64_t edges = 0;
    for (const Contraction& contraction : contractions) edges += contraction.edges.size();
    return edges;
  }

  const EvidenceGraph& graph;
  StageFixture& stage;
  std::vector<EvidenceWindow> windows;
  std::vector<Contraction> contractions;
};

std::vector<std::uint32_t> random_cuts(std::uint32_t ranks, std::size_t windows,
                                       std::mt19937_64& random) {
  std::set<std::uint32_t> cuts{0, ranks};
  while (cuts.size() < windows + 1) cuts.insert(static_cast<std::uint32_t>(random() % ranks));
  return {cuts.begin(), cuts.end()};
}

EvidenceGraphOptions options_of(std::uint64_t seed) {
  return {.ranks = static_cast<std::uint32_t>(60 + seed * 29 % 200),
          .nodes = static_cast<std::uint32_t>(150 + seed * 37 % 600),
          .edges = static_cast<std::uint32_t>(100 + seed * 211 % 3000),
          .weights = static_cast<std::uint32_t>(seed % 5 * 2),
          .spread = static_cast<std::uint32_t>(6 + seed % 3 * 12),
          .infinite = static_cast<std::uint32_t>(seed % 4 * 15)};
}

std::uint64_t levels_for(std::uint64_t parts, std::uint64_t fan_in) {
  std::uint64_t levels = 0;
  do {
    parts = (parts + fan_in - 1) / fan_in;
    ++levels;
  } while (parts > 1);
  return levels;
}

TEST(ForestMerge, GivesTheLabelsOfTheWholeHoweverItIsCutAndJoined) {
  for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    std::mt19937_64 random(seed);
    const EvidenceGraph graph = random_graph(options_of(seed), random);
    const auto cuts = random_cuts(graph.ranks, 1 + seed * 7 % 24, random);
    const std::uint64_t fan_in = 2 + seed % 3;
    StageFixture stage(seed % 4 == 0 ? kUnlimited : budget_for(fan_in));
    const Exported exported(graph, cuts, stage);
    const MergedForest forest = exported.merge();
    exported.expect_labels(forest);
    EXPECT_EQ(forest.counts.nodes, exported.border().size());
    EXPECT_EQ(forest.counts.edges, exported.edges());
    if (stage.budget.limit() != kUnlimited) {
      EXPECT_EQ(forest.counts.levels, levels_for(exported.windows.size(), fan_in));
    }
    EXPECT_LE(stage.budget.peak(), stage.budget.limit());
  }
}

TEST(ForestMerge, IsTheSameForEveryCutOfOneGraph) {
  std::mt19937_64 random(5);
  const EvidenceGraph graph = random_graph({.edges = 4000, .weights = 2}, random);
  for (std::size_t windows = 1; windows <= 40; windows += 3) {
    SCOPED_TRACE(testing::Message() << windows << " windows");
    StageFixture stage(budget_for(3));
    const Exported exported(graph, random_cuts(graph.ranks, windows, random), stage);
    exported.expect_labels(exported.merge());
  }
}

TEST(ForestMerge, IsTheSameOnAnyNumberOfThreads) {
  std::mt19937_64 random(12);
  const EvidenceGraph graph = random_graph({.edges = 4000, .weights = 2}, random);
  const auto cuts = random_cuts(graph.ranks, 24, random);
  for (const unsigned threads : {1U, 2U, 4U}) {
    for (const std::uint64_t memory : {kUnlimited, budget_for(9)}) {
      SCOPED_TRACE(testing::Message() << threads << " threads, " << memory << " bytes");
      const ThreadLimit limit(threads);
      StageFixture stage(memory);
      const Exported exported(graph, cuts, stage);
      const MergedForest forest = exported.merge();
      exported.expect_labels(forest);
      EXPECT_EQ(forest.counts.nodes, exported.border().size());
      if (memory == kUnlimited) {
        EXPECT_EQ(forest.counts.levels > 1, threads_in_use() > 1);
      }
      EXPECT_LE(stage.budget.peak(), stage.budget.limit());
    }
  }
}

TEST(JoinPlan, SharesPartsOutEvenlyWithinTheMemory) {
  std::mt19937_64 random(13);
  for (int round = 0; round < 500; ++round) {
    SCOPED_TRACE(testing::Message() << "round " << round);
    std::vector<EvidencePart> parts(1 + random() % 40);
    std::uint64_t nodes = 0;
    std::uint64_t largest = 0;
    for (EvidencePart& part : parts) {
      part.nodes = random() % 100000;
      nodes += part.nodes;
      largest = std::max(largest, part.nodes);
    }
    const bool is_ample = round % 2 == 0;
    const JoinResources resources{
        .memory_bytes = is_ample ? kUnlimited / 2 : join_memory({2 + random() % 20, 300000}),
        .threads = 1 + random() % 6};
    const JoinPlan plan = plan_joins(parts, resources);
    EXPECT_LE(plan.at_once, resources.threads);
    if (plan.at_once > 1) {
      EXPECT_LE(plan.ends.size(), parts.size() / 2);
    }
    std::size_t begin = 0;
    for (const std::size_t end : plan.ends) {
      ASSERT_LT(begin, end);
      JoinSize size;
      for (; begin < end; ++begin) size.add(parts[begin]);
      if (size.parts > 1) {
        EXPECT_LE(join_memory(size) * plan.at_once, resources.memory_bytes);
      }
      EXPECT_LE(size.nodes, nodes / plan.at_once + largest + 1);
    }
    EXPECT_EQ(begin, parts.size());
    if (is_ample) {
      EXPECT_EQ(plan.at_once, std::clamp<std::size_t>(parts.size() / 2, 1, resources.threads));
    }
  }
}

TEST(ForestMerge, PassesOverWindowsWithoutEvidence) {
  std::mt19937_64 random(6);
  EvidenceGraph graph = random_graph({.edges = 3000, .weights = 3}, random);
  std::erase_if(graph.edges, [](const auto& edge) {
    return edge.rank < 30 || (edge.rank >= 80 && edge.rank < 120) || edge.rank >= 170;
  });
  StageFixture stage(budget_for(2));
  const Exported exported(graph, {0, 20, 30, 50, 85, 100, 115, 140, 170, 185, 200}, stage);
  ASSERT_EQ(exported.windows.size(), 4U);
  exported.expect_labels(exported.merge());
}

TEST(ForestMerge, HasNoLabelsWithoutEvidence) {
  StageFixture stage;
  const ExportReader reader(stage.scratch, stage.budget);
  const MergedForest forest = merge_forest(reader, stage.context);
  EXPECT_EQ(forest.counts.levels, 0U);
  EXPECT_EQ(forest.labels.labels(0).size(), 0U);
}

TEST(ForestMerge, CountsWhatNoEvidenceLeadsToAndLeavesItOutside) {
  std::mt19937_64 random(7);
  const EvidenceGraph graph = random_graph({.infinite = 0}, random);
  StageFixture stage;
  const Exported exported(graph, {0, 50, 100, 200}, stage);
  const MergedForest forest = exported.merge();
  std::uint64_t finite = 0;
  for (const EvidenceWindow& window : exported.windows) {
    finite += window.border_keys(graph).size() - 1;
  }
  EXPECT_EQ(forest.counts.unattached, finite);
  exported.expect_labels(forest);
}

TEST(ForestMerge, LeavesNothingButLabelsInScratchAndThoseAsLongAsTheyAreUsed) {
  std::mt19937_64 random(8);
  const EvidenceGraph graph = random_graph({}, random);
  StageFixture stage(budget_for(2));
  const Exported exported(graph, {0, 30, 60, 90, 120, 150, 200}, stage);
  const auto before = stage.scratch.names();
  {
    const MergedForest forest = exported.merge();
    EXPECT_EQ(stage.scratch.names().size(), before.size() + 1);
    EXPECT_LT(stage.budget.used(), 1000U);
  }
  EXPECT_EQ(stage.scratch.names(), before);
  EXPECT_EQ(stage.budget.used(), 0U);
}

TEST(ForestMerge, SaysHowMuchMemoryTwoNeighboursNeed) {
  std::mt19937_64 random(9);
  const EvidenceGraph graph = random_graph({}, random);
  StageFixture stage(join_memory({.parts = 2, .nodes = 0}));
  const Exported exported(graph, {0, 100, 200}, stage);
  try {
    (void)exported.merge();
    FAIL() << "two windows in the memory of none";
  } catch (const BudgetError& error) {
    EXPECT_THAT(error.what(), HasSubstr("joining the evidence of two neighbouring windows needs"));
    EXPECT_THAT(error.what(), HasSubstr("give --memory"));
  }
}

TEST(ForestMerge, StopsWhenAsked) {
  std::mt19937_64 random(10);
  const EvidenceGraph graph = random_graph({.nodes = 20000, .edges = 40000}, random);
  StageFixture stage;
  const Exported exported(graph, {0, 100, 200}, stage);
  stage.stop.request();
  EXPECT_THROW((void)exported.merge(), Interrupted);
}

TEST(ForestMerge, NoticesEveryChangedByteOfAnExport) {
  std::mt19937_64 random(11);
  const EvidenceGraph graph = random_graph({}, random);
  StageFixture stage;
  const Exported exported(graph, {0, 100, 200}, stage);
  const std::string path = stage.scratch.path() + "/" + export_name(100);
  const std::string intact = file_bytes(path);
  for (int i = 0; i < 50; ++i) {
    std::string bytes = intact;
    const std::size_t at = random() % bytes.size();
    bytes[at] = static_cast<char>(bytes[at] ^ (1 << random() % 8));
    put_bytes(path, bytes);
    EXPECT_THROW((void)exported.merge(), IoError) << "byte " << at;
  }
  put_bytes(path, intact);
  exported.expect_labels(exported.merge());
}

/// Merges one window's export with these records.
void merge_records(const std::vector<NodeKey>& nodes, const std::vector<EvidenceEdge>& edges) {
  StageFixture stage;
  ExportWriter writer(stage.scratch, 0);
  for (const NodeKey& key : nodes) writer.add(ExportKind::kEvidenceNodes, 0, key);
  for (const EvidenceEdge& edge : edges) writer.add(ExportKind::kEvidenceEdges, 0, edge);
  writer.finish();
  const ExportReader reader(stage.scratch, stage.budget);
  (void)merge_forest(reader, stage.context);
}

TEST(ForestMerge, RefusesRecordsThatNoWindowWouldHandOn) {
  const NodeKey first{{0, 1, 2, 3}};
  const EvidenceEdge light{.a = 0, .b = 1, .weight = 1, .tie = {1, 0, 0}};
  const EvidenceEdge heavy{.a = 0, .b = 1, .weight = 2, .tie = {2, 0, 0}};
  EXPECT_NO_THROW(merge_records({first, kInfiniteNode}, {heavy, light}));
  EXPECT_THROW(merge_records({kInfiniteNode, first}, {heavy, light}), IoError) << "nodes fall";
  EXPECT_THROW(merge_records({first, kInfiniteNode}, {light, heavy}), IoError) << "weights rise";
  EXPECT_THROW(merge_records({first, kInfiniteNode}, {light, light}), IoError) << "an edge twice";
  EXPECT_THROW(merge_records({first}, {light}), IoError) << "a node that is not there";
  EvidenceEdge bad = light;
  bad.weight = std::numeric_limits<float>::quiet_NaN();
  EXPECT_THROW(merge_records({first, kInfiniteNode}, {bad}), IoError) << "no number";
}

}  // namespace
}  // namespace stream_recon
