// The signed maximum spanning forest of a part of the evidence graph, with everything contracted
// that no other part can see.
//
// A part's border nodes may have more edges elsewhere; all edges of its other nodes, the private
// ones, are here. Guarantees: the forest of the whole graph is what was contracted here and the
// forest of the edges that add() returned, merged with those of the other parts: exactly, also
// where signs contradict each other (proof: docs/algorithms/labels.md). No more edges are returned
// than there are border nodes. Thread rule: one thread. Memory: memory(). Cost: two searches in a
// union-find an edge, about 60 ns.
// Source: Kruskal 1956; Tarjan, Data Structures and Network Algorithms, 1983, chapters 2 and 6.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "engine/labels/attachment.h"
#include "engine/labels/evidence_records.h"
#include "engine/node_set.h"

namespace stream_recon {

class SignedForest {
 public:
  /// \param border among the nodes of the part \pre At most Attachment::kMostNodes nodes
  explicit SignedForest(const NodeSet& border);

  /// Bytes for `nodes` nodes.
  static constexpr std::uint64_t memory(std::uint64_t nodes) { return nodes * sizeof(Attachment); }

  /// Takes an edge, no earlier than those that come before it; its tie is only passed on. \return
  /// What is left of it for the whole: an edge between border nodes, with the same weight and tie,
  /// or nothing
  std::optional<EvidenceEdge> add(const EvidenceEdge& edge);

  /// An edge of these nodes is taken soon.
  void prefetch(const EvidenceEdge& edge) const {
    __builtin_prefetch(&links_[edge.a]);
    __builtin_prefetch(&links_[edge.b]);
  }

  /// What every node hangs on. \pre No more edges; called once
  std::vector<Attachment> attachments() &&;

 private:
  /// Where a node hangs for now: on a border node, or on a private one that stands for a component
  /// without border nodes. `is_attached` tells which.
  Attachment find_top(std::uint32_t node);
  std::uint32_t find_component(std::uint32_t border);

  /// Of a border node, marked as attached: another one of its component, or itself. Of a private
  /// node: what it hangs on; itself if it stands for its component.
  std::vector<Attachment> links_;
  float last_weight_ = std::numeric_limits<float>::infinity();
};

/// A part as the whole sees it.
struct Contraction {
  std::vector<Attachment> attachments;  ///< of every node
  std::vector<EvidenceEdge> edges;      ///< between border nodes, in their order
  std::uint64_t unattached = 0;         ///< nodes that hang on nothing
};

/// All at once, from edges in any order, whose memory is used again for the result.
/// \param border numbered
Contraction contract(const NodeSet& border, std::vector<EvidenceEdge> edges);

/// What contract() holds beside the edges that it is given, 24 bytes each, and the set of the
/// border nodes, NodeSet::memory().
constexpr std::uint64_t contraction_memory(std::uint64_t nodes) {
  return SignedForest::memory(nodes);
}

}  // namespace stream_recon
