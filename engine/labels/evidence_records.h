// What windows tell each other about inside and outside: nodes and edges of the evidence graph.
//
// A node is a tetrahedron, or the one infinite node, which stands for all infinite cells. An edge
// says with some weight that its nodes lie on the same side of the surface, or on opposite sides.
// Thread rule: values. Memory: 16 bytes a node, 24 bytes an edge, on disk as in memory
// (docs/formats.md).
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <type_traits>

namespace stream_recon {

/// Names a node in the whole cloud: the ranks of its four points.
struct NodeKey {
  std::array<std::uint32_t, 4> ranks{};  ///< ascending

  friend bool operator==(const NodeKey&, const NodeKey&) = default;
  friend bool operator<(const NodeKey& a, const NodeKey& b) { return a.ranks < b.ranks; }
};

/// Comes last of all keys.
inline constexpr NodeKey kInfiniteNode{{0xffffffff, 0xffffffff, 0xffffffff, 0xffffffff}};

struct EvidenceEdge {
  std::uint32_t a = 0;  ///< number of a node, or its position in a table of nodes; below 2^30
  std::uint32_t b : 31 = 0;
  bool is_opposite : 1 = false;
  float weight = 0;                    ///< finite, not negative
  std::array<std::uint32_t, 3> tie{};  ///< no two edges of a cloud share weight and tie
};

static_assert(sizeof(NodeKey) == 16 && std::is_trivially_copyable_v<NodeKey>);
static_assert(sizeof(EvidenceEdge) == 24 && std::is_trivially_copyable_v<EvidenceEdge>);

/// The order in which a forest takes edges: by falling weight, then by rising tie. Total.
inline bool comes_before(const EvidenceEdge& x, const EvidenceEdge& y) {
  return x.weight != y.weight ? x.weight > y.weight : x.tie < y.tie;
}

}  // namespace stream_recon
