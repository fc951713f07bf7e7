// Random evidence graphs of a cloud that does not exist, and their labels the simple way.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <random>
#include <set>
#include <utility>
#include <vector>

#include "engine/labels/evidence_records.h"

namespace stream_recon {

struct EvidenceGraphOptions {
  std::uint32_t ranks = 200;
  std::uint32_t nodes = 600;  ///< finite ones
  std::uint32_t edges = 1500;
  std::uint32_t weights = 0;    ///< how many different ones; 0: any
  std::uint32_t spread = 12;    ///< ranks of a node are mostly this close
  std::uint32_t infinite = 10;  ///< one edge of so many leads to the infinite node; 0: none
};

/// Edges name nodes by their place; each belongs to the window that owns a rank of both its nodes.
struct EvidenceGraph {
  struct Edge {
    EvidenceEdge edge;
    std::uint32_t rank = 0;
  };

  std::uint32_t ranks = 0;
  std::vector<NodeKey> nodes;  ///< ascending, the infinite one last
  std::vector<Edge> edges;
};

namespace evidence_graphs {

inline NodeKey random_node(const EvidenceGraphOptions& options, std::mt19937_64& random) {
  std::set<std::uint32_t> ranks;
  const auto base = static_cast<std::uint32_t>(random() % options.ranks);
  while (ranks.size() < 4) {
    const bool is_far = random() % 40 == 0;
    const std::uint64_t near = base + random() % options.spread;
    ranks.insert(static_cast<std::uint32_t>((is_far ? random() : near) % options.ranks));
  }
  NodeKey key;
  std::copy(ranks.begin(), ranks.end(), key.ranks.begin());
  return key;
}

inline std::vector<NodeKey> random_nodes(const EvidenceGraphOptions& options,
                                         std::mt19937_64& random) {
  std::set<NodeKey> nodes;
  while (nodes.size() < options.nodes) nodes.insert(random_node(options, random));
  std::vector<NodeKey> result(nodes.begin(), nodes.end());
  result.push_back(kInfiniteNode);
  return result;
}

inline float random_weight(const EvidenceGraphOptions& options, std::mt19937_64& random) {
  if (options.weights != 0) return static_cast<float>(random() % options.weights);
  return std::uniform_real_distribution<float>(0, 10)(random);
}

inline EvidenceGraph random_graph(const EvidenceGraphOptions& options, std::mt19937_64& random) {
  EvidenceGraph graph{.ranks = options.ranks, .nodes = random_nodes(options, random), .edges = {}};
  std::vector<std::vector<std::uint32_t>> nodes_at(options.ranks);
  for (std::uint32_t n = 0; n + 1 < graph.nodes.size(); ++n) {
    for (const std::uint32_t rank : graph.nodes[n].ranks) nodes_at[rank].push_back(n);
  }
  for (std::uint32_t i = 0; i < options.edges; ++i) {
    const auto a = static_cast<std::uint32_t>(random() % options.nodes);
    const std::uint32_t rank = graph.nodes[a].ranks[random() % 4];
    const bool is_infinite = options.infinite != 0 && random() % options.infinite == 0;
    const std::uint32_t b =
        is_infinite ? options.nodes : nodes_at[rank][random() % nodes_at[rank].size()];
    const EvidenceEdge edge{.a = a,
                            .b = b,
                            .is_opposite = random() % 3 == 0,
                            .weight = random_weight(options, random),
                            .tie = {rank, static_cast<std::uint32_t>(random() % 3), i}};
    graph.edges.push_back({edge, rank});
  }
  return graph;
}

/// Inside or not, of every node: Kruskal's algorithm, renaming components node by node.
inline std::vector<bool> reference_labels(const EvidenceGraph& graph) {
  std::vector<EvidenceEdge> edges;
  for (const auto& edge : graph.edges) edges.push_back(edge.edge);
  std::sort(edges.begin(), edges.end(), comes_before);
  std::vector<std::size_t> component(graph.nodes.size());
  std::vector<bool> sign(graph.nodes.size());
  for (std::size_t n = 0; n < component.size(); ++n) component[n] = n;
  for (const EvidenceEdge& edge : edges) {
    const std::size_t from = component[edge.a];
    const std::size_t to = component[edge.b];
    if (from == to) continue;
    const bool turns = (sign[edge.a] != sign[edge.b]) != edge.is_opposite;
    for (std::size_t n = 0; n < component.size(); ++n) {
      if (component[n] != from) continue;
      component[n] = to;
      sign[n] = sign[n] != turns;
    }
  }
  std::vector<bool> labels(graph.nodes.size());
  for (std::size_t n = 0; n < labels.size(); ++n) {
    labels[n] = component[n] == component.back() && sign[n] != sign.back();
  }
  return labels;
}

}  // namespace evidence_graphs
}  // namespace stream_recon
