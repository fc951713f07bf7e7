#include "engine/surface/chunk_pieces.h"

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

#include "engine/surface/piece_forest.h"

namespace stream_recon {
namespace {

constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

std::uint32_t position_of(PointRank rank, std::span<const PointRank> ranks) {
  const auto at = std::lower_bound(ranks.begin(), ranks.end(), rank);
  if (at == ranks.end() || *at != rank) return kNone;
  return static_cast<std::uint32_t>(at - ranks.begin());
}

/// Uses of edges that earlier chunks have too, then of those that belong to later chunks.
std::vector<EdgeUse> shared_uses(const EdgeCensus::ChunkEdges& edges) {
  const auto& uses = edges.uses;
  const auto is_before = [](const EdgeUse& a, const EdgeUse& b) {
    return std::tie(a.low, a.high) < std::tie(b.low, b.high);
  };
  std::vector<EdgeUse> shared;
  for (std::size_t i = 0; i < edges.handed_over.size(); ++i) {
    const BorderEdge& edge = edges.handed_over[i];
    if (i > 0 && edge == edges.handed_over[i - 1]) continue;
    const EdgeUse wanted{position_of(edge.low, edges.ranks), position_of(edge.high, edges.ranks)};
    if (wanted.low == kNone || wanted.high == kNone) continue;
    const auto [begin, end] = std::equal_range(uses.begin(), uses.end(), wanted, is_before);
    shared.insert(shared.end(), begin, end);
  }
  const auto own = std::lower_bound(edges.ranks.begin(), edges.ranks.end(), edges.end);
  const auto first_later = static_cast<std::uint32_t>(own - edges.ranks.begin());
  const auto later = std::partition_point(
      uses.begin(), uses.end(), [first_later](const EdgeUse& u) { return u.low < first_later; });
  shared.insert(shared.end(), later, uses.end());
  return shared;
}

}  // namespace

SharedEdge edge_of_use(const EdgeUse& use, const LocalTriangle& triangle,
                       std::span<const PointRank> ranks) {
  constexpr std::array<int, 3> kApexOfSide{2, 0, 1};
  return {ranks[use.low], ranks[use.high], ranks[triangle[kApexOfSide[use.use % 3]]]};
}

ChunkPieces number_pieces(std::vector<std::uint32_t> roots, std::span<const EdgeUse> shared) {
  ChunkPieces pieces;
  std::vector<std::uint32_t> number(roots.size(), kNone);
  for (const EdgeUse& use : shared) {
    std::uint32_t& of_root = number[roots[use.triangle()]];
    if (of_root == kNone) of_root = pieces.reaching++;
  }
  pieces.count = pieces.reaching;
  for (std::uint32_t t = 0; t < roots.size(); ++t) {
    if (roots[t] == t && number[t] == kNone) number[t] = pieces.count++;
  }
  for (std::uint32_t& root : roots) root = number[root];
  pieces.of_triangle = std::move(roots);
  return pieces;
}

ChunkPieces pieces_at_edges(std::vector<std::uint32_t> two_sided, const ChunkFacets& facets,
                            const EdgeCensus::ChunkEdges& edges) {
  PieceForest<std::uint32_t> forest(std::move(two_sided));
  for_each_edge(edges.uses, [&forest](std::span<const EdgeUse> uses) {
    for (std::size_t i = 2; i < uses.size(); ++i) {
      forest.join(uses[0].triangle(), uses[i].triangle());
      forest.join(uses[1].triangle(), uses[i].triangle());
    }
  });
  const std::vector<EdgeUse> shared = shared_uses(edges);
  ChunkPieces pieces = number_pieces(forest.take_roots(), shared);
  pieces.told.reserve(shared.size());
  for (const EdgeUse& use : shared) {
    const std::uint32_t t = use.triangle();
    const SharedEdge edge = edge_of_use(use, facets.triangles[t], edges.ranks);
    pieces.told.push_back(SharedEdge::use(edge, pieces.of_triangle[t], false));
  }
  return pieces;
}

}  // namespace stream_recon
