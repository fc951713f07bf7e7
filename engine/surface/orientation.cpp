#include "engine/surface/orientation.h"

#include <numeric>
#include <utility>

namespace stream_recon {
namespace {

/// Triangles joined into components, each with its parity to the component's lowest triangle.
class ParityForest {
 public:
  explicit ParityForest(std::size_t size) : parent_(size), odd_(size, false) {
    std::iota(parent_.begin(), parent_.end(), 0U);
  }

  struct Root {
    std::uint32_t triangle;
    bool odd;
  };

  Root find(std::uint32_t t) {
    Root root{t, false};
    while (parent_[root.triangle] != root.triangle) {
      root.odd = root.odd != odd_[root.triangle];
      root.triangle = parent_[root.triangle];
    }
    compress(t, root);
    return root;
  }

  /// Joins two components so that a and b differ iff `odd`; a contradiction is left standing.
  void join(std::uint32_t a, std::uint32_t b, bool odd) {
    Root low = find(a);
    Root high = find(b);
    if (low.triangle == high.triangle) return;
    if (low.triangle > high.triangle) std::swap(low, high);
    parent_[high.triangle] = low.triangle;
    odd_[high.triangle] = (low.odd != high.odd) != odd;
  }

 private:
  void compress(std::uint32_t t, Root root) {
    while (parent_[t] != root.triangle && t != root.triangle) {
      const std::uint32_t next = parent_[t];
      const bool odd = odd_[t];
      parent_[t] = root.triangle;
      odd_[t] = root.odd;
      root.odd = root.odd != odd;
      t = next;
    }
  }

  std::vector<std::uint32_t> parent_;
  std::vector<bool> odd_;
};

}  // namespace

std::vector<bool> reversals(std::span<const EdgeUse> uses, std::span<const Facing> facing) {
  ParityForest forest(facing.size());
  for_each_edge(uses, [&forest](std::span<const EdgeUse> edge) {
    if (edge.size() != 2) return;
    forest.join(edge[0].triangle(), edge[1].triangle(), edge[0].ascending() == edge[1].ascending());
  });

  std::vector<std::int32_t> outward(facing.size(), 0);
  for (std::uint32_t t = 0; t < facing.size(); ++t) {
    const auto root = forest.find(t);
    outward[root.triangle] += static_cast<int>(facing[t]) * (root.odd ? -1 : 1);
  }
  std::vector<bool> reversed(facing.size());
  for (std::uint32_t t = 0; t < facing.size(); ++t) {
    const auto root = forest.find(t);
    reversed[t] = root.odd != (outward[root.triangle] < 0);
  }
  return reversed;
}

std::vector<bool> turned_outward(std::span<const Facing> facing) {
  std::vector<bool> reversed(facing.size());
  for (std::size_t t = 0; t < facing.size(); ++t) reversed[t] = facing[t] == Facing::kInward;
  return reversed;
}

}  // namespace stream_recon
