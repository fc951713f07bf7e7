// Inside or outside, of the nodes of one table.
//
// Thread rule: a value. Memory: 2 bits a node, reserved where it comes from a budget.
#pragma once

#include <cassert>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "engine/budget.h"
#include "engine/labels/attachment.h"

namespace stream_recon {

enum class NodeLabel : std::uint8_t {
  kUnattached,  ///< no evidence leads to the infinite node: outside by convention
  kOutside,
  kInside,
};

class NodeLabels {
 public:
  /// All unattached.
  NodeLabels(std::uint64_t nodes, Reservation memory)
      : memory_(std::move(memory)), nodes_(nodes), words_(words_for(nodes)) {}

  static constexpr std::uint64_t kNodesAWord = 32;
  static constexpr std::uint64_t words_for(std::uint64_t nodes) {
    return (nodes + kNodesAWord - 1) / kNodesAWord;
  }
  static constexpr std::uint64_t memory(std::uint64_t nodes) {
    return words_for(nodes) * sizeof(std::uint64_t);
  }

  std::uint64_t size() const { return nodes_; }
  /// \param node position in the table
  NodeLabel label(std::uint64_t node) const {
    assert(node < nodes_);
    return static_cast<NodeLabel>(words_[node / kNodesAWord] >> node % kNodesAWord * 2 & 3);
  }
  /// Of a node that hangs on one of the table.
  NodeLabel label(const Attachment& at) const {
    if (!at.is_attached) return NodeLabel::kUnattached;
    const NodeLabel other = label(std::uint64_t{at.node});
    if (other == NodeLabel::kUnattached || !at.is_opposite) return other;
    return other == NodeLabel::kInside ? NodeLabel::kOutside : NodeLabel::kInside;
  }

  /// Two bits a node, the lowest bits first.
  std::span<std::uint64_t> words() { return words_; }

 private:
  Reservation memory_;
  std::uint64_t nodes_;
  std::vector<std::uint64_t> words_;
};

}  // namespace stream_recon
