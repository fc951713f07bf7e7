// Things with numbers, joined into pieces: union-find.
//
// Guarantees: a piece's root is its lowest number, whatever the order of joins. Thread rule: one
// thread. Memory: one Number each. Cost: nearly constant. Source: Tarjan 1975.
#pragma once

#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace stream_recon {

template <class Number>
class PieceForest {
 public:
  explicit PieceForest(std::size_t size) : parent_(size) {
    std::iota(parent_.begin(), parent_.end(), Number{0});
  }
  /// Of things that are joined already. \param roots of each
  explicit PieceForest(std::vector<Number> roots) : parent_(std::move(roots)) {}

  std::size_t size() const { return parent_.size(); }

  Number find(Number i) {
    while (parent_[i] != i) {
      parent_[i] = parent_[parent_[i]];
      i = parent_[i];
    }
    return i;
  }

  /// False if they were joined already.
  bool join(Number a, Number b) {
    a = find(a);
    b = find(b);
    if (a == b) return false;
    if (b < a) std::swap(a, b);
    parent_[b] = a;
    return true;
  }

  /// The root of each, and the end of the forest.
  std::vector<Number> take_roots() {
    // A parent is lower than its child, so its root is known by then.
    for (Number& parent : parent_) parent = parent_[parent];
    return std::move(parent_);
  }

 private:
  std::vector<Number> parent_;
};

}  // namespace stream_recon
