// How the index over the Hilbert order is cut: leaves, pages, top.
//
// A packed tree: a leaf is 16 consecutive ranks, a node four consecutive children, so that position
// says everything and no link is stored. A page holds the tree over 4096 ranks, 341 nodes from its
// root (0) down to its leaves (85 .. 340), children of node i at 4 i + 1 .. 4 i + 4. The roots of
// the pages are the lowest level of the top, which stays in memory: 32 bytes for 1000 points.
#pragma once

#include <cstddef>
#include <cstdint>

#include "engine/windows/final_window.h"

namespace stream_recon::index_layout {

inline constexpr std::uint64_t kFanout = 4;
inline constexpr std::uint64_t kLeafPoints = 16;
inline constexpr std::uint64_t kPageLeaves = 256;
inline constexpr std::uint64_t kPagePoints = kLeafPoints * kPageLeaves;
inline constexpr std::uint32_t kFirstLeaf = 1 + 4 + 16 + 64;
inline constexpr std::uint32_t kPageNodes = kFirstLeaf + kPageLeaves;

using LeafNumber = std::uint64_t;

struct LeafRange {
  LeafNumber begin = 0;
  LeafNumber end = 0;
};

constexpr std::uint64_t quotient_up(std::uint64_t count, std::uint64_t by) {
  return count / by + (count % by != 0 ? 1 : 0);
}
constexpr LeafNumber leaf_of(PointRank rank) {
  return rank / kLeafPoints;
}

/// The leaves below a node of a page, and beyond the end of the cloud for the last page.
constexpr LeafRange leaves_below(std::uint64_t page, std::uint32_t node) {
  std::uint32_t first = node;
  std::uint64_t count = 1;
  while (first < kFirstLeaf) {
    first = 4 * first + 1;
    count *= kFanout;
  }
  const LeafNumber begin = page * kPageLeaves + (first - kFirstLeaf);
  return {begin, begin + count};
}

/// The leaves below a node of the top, level 0 being the roots of the pages; the last node of a
/// level may reach beyond the end of the cloud.
constexpr LeafRange leaves_below_top(std::size_t level, std::uint64_t node) {
  std::uint64_t count = kPageLeaves;
  for (std::size_t l = 0; l < level; ++l) count *= kFanout;
  return {node * count, (node + 1) * count};
}

}  // namespace stream_recon::index_layout
