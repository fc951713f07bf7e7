// Inside or outside, of the nodes of one table.
//
// Thread rule: a value. Memory: a bit a node, reserved where it comes from a budget.
#pragma once

#include <cassert>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "engine/budget.h"

namespace stream_recon {

class NodeLabels {
 public:
  /// All outside.
  NodeLabels(std::uint64_t nodes, Reservation memory)
      : memory_(std::move(memory)), nodes_(nodes), words_(words_for(nodes)) {}

  static constexpr std::uint64_t words_for(std::uint64_t nodes) { return (nodes + 63) / 64; }
  static constexpr std::uint64_t memory(std::uint64_t nodes) { return words_for(nodes) * 8; }

  std::uint64_t size() const { return nodes_; }
  bool is_inside(std::uint64_t node) const {
    assert(node < nodes_);
    return (words_[node / 64] >> node % 64 & 1) != 0;
  }

  /// Bit i of word w is that of node 64 w + i, set: inside.
  std::span<std::uint64_t> words() { return words_; }

 private:
  Reservation memory_;
  std::uint64_t nodes_;
  std::vector<std::uint64_t> words_;
};

}  // namespace stream_recon
