// Windows on a random evidence graph: what each sees, contracts and hands on.
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <vector>

#include "engine/labels/evidence_export.h"
#include "engine/labels/signed_forest.h"
#include "tests/evidence_graphs.h"

namespace stream_recon {

/// The window of ranks [first, end).
struct EvidenceWindow {
  EvidenceWindow(const EvidenceGraph& graph, std::uint32_t first_rank, std::uint32_t end_rank)
      : first(first_rank), end(end_rank) {
    constexpr auto kNone = std::numeric_limits<std::uint32_t>::max();
    std::vector<std::uint32_t> numbers(graph.nodes.size(), kNone);
    for (std::uint32_t n = 0; n < graph.nodes.size(); ++n) {
      const std::uint32_t mirrored = static_cast<std::uint32_t>(graph.nodes.size()) - 1 - n;
      if (!sees(graph.nodes[mirrored])) continue;
      numbers[mirrored] = static_cast<std::uint32_t>(nodes.size());
      nodes.push_back(mirrored);
    }
    for (const auto& edge : graph.edges) {
      if (!owns(edge.rank)) continue;
      edges.push_back(edge.edge);
      edges.back().a = numbers[edge.edge.a];
      edges.back().b = numbers[edge.edge.b];
    }
  }

  bool owns(std::uint32_t rank) const { return rank >= first && rank < end; }
  bool sees(const NodeKey& key) const {
    return key == kInfiniteNode || std::any_of(key.ranks.begin(), key.ranks.end(),
                                               [this](std::uint32_t rank) { return owns(rank); });
  }
  bool is_border(const NodeKey& key) const {
    return !std::all_of(key.ranks.begin(), key.ranks.end(),
                        [this](std::uint32_t rank) { return owns(rank); });
  }
  NodeSet border(const EvidenceGraph& graph) const {
    NodeSet border(static_cast<std::uint32_t>(nodes.size()));
    for (std::uint32_t i = 0; i < nodes.size(); ++i) {
      if (is_border(graph.nodes[nodes[i]])) border.insert(i);
    }
    border.number();
    return border;
  }
  std::vector<NodeKey> border_keys(const EvidenceGraph& graph) const {
    std::vector<NodeKey> keys;
    for (const std::uint32_t node : nodes) {
      if (is_border(graph.nodes[node])) keys.push_back(graph.nodes[node]);
    }
    return keys;
  }

  std::uint32_t first;
  std::uint32_t end;
  std::vector<std::uint32_t> nodes;  ///< places in the graph, in the order of the window's numbers
  std::vector<EvidenceEdge> edges;
};

/// Hands on what the window sees. \return What its nodes hang on, by position in its table
inline Contraction export_window(const EvidenceGraph& graph, const EvidenceWindow& window,
                                 ScratchDirectory& scratch) {
  const NodeSet border = window.border(graph);
  Contraction contraction = contract(border, window.edges);
  ExportWriter writer(scratch, window.first);
  export_evidence({window.first, border, window.border_keys(graph)}, contraction, writer);
  writer.finish();
  return contraction;
}

}  // namespace stream_recon
