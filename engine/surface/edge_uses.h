// The edges of a chunk's triangles, sorted so that all uses of an edge stand together.
//
// Thread rule: pure functions. Memory: 12 bytes a use, 36 a triangle.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <tuple>
#include <vector>

namespace stream_recon {

/// Corners of a triangle as positions in the vertex list of its chunk, ascending.
using LocalTriangle = std::array<std::uint32_t, 3>;

struct EdgeUse {
  std::uint32_t low = 0;  ///< vertex of the lower position
  std::uint32_t high = 0;
  std::uint32_t use = 0;  ///< 3 * triangle + side

  std::uint32_t triangle() const { return use / 3; }
  /// Whether the triangle's ascending order runs along the edge from low to high.
  bool ascending() const { return use % 3 != 2; }

  friend bool operator==(const EdgeUse&, const EdgeUse&) = default;
  friend bool operator<(const EdgeUse& a, const EdgeUse& b) {
    return std::tie(a.low, a.high, a.use) < std::tie(b.low, b.high, b.use);
  }
};

/// All uses, sorted. \pre fewer than 2^32 / 3 triangles
std::vector<EdgeUse> sorted_edge_uses(std::span<const LocalTriangle> triangles);

/// Calls visit(uses) for the uses of each edge, in order.
template <class Visit>
void for_each_edge(std::span<const EdgeUse> sorted, const Visit& visit) {
  for (std::size_t begin = 0; begin < sorted.size();) {
    std::size_t end = begin + 1;
    while (end < sorted.size() && sorted[end].low == sorted[begin].low &&
           sorted[end].high == sorted[begin].high) {
      ++end;
    }
    visit(sorted.subspan(begin, end - begin));
    begin = end;
  }
}

}  // namespace stream_recon
