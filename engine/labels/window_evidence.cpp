#include "engine/labels/window_evidence.h"

#include <algorithm>
#include <bit>
#include <boost/sort/spreadsort/integer_sort.hpp>
#include <cassert>

#include "engine/surface/ranked_facet.h"
#include "spatial/side_evidence.h"
#include "spatial/vector.h"

namespace stream_recon {
namespace {

constexpr std::size_t kBlock = 32;

/// Bits of floats that are not negative are ordered as the floats are.
std::uint32_t key_of(double weight) {
  return std::bit_cast<std::uint32_t>(static_cast<float>(weight));
}

/// Whether the corners, an order of the facet's, run as it does: an even permutation.
bool is_outward(const std::array<VertexId, 3>& facet, const std::array<VertexId, 3>& corners) {
  const auto at = std::find(facet.begin(), facet.end(), corners[0]) - facet.begin();
  return facet[(at + 1) % 3] == corners[1];
}

}  // namespace

WindowEvidence::WindowEvidence(const FinalWindow& window, std::span<const float> spacing,
                               const StarBalls& balls)
    : window_(window),
      cells_(window.delaunay().view()),
      nodes_(balls.cells()),
      spacing_(spacing),
      poles_(window, balls),
      first_pair_name_(~(window.owned_count() - 1)) {
  assert(4 * std::uint64_t{cells_.slots()} < first_pair_name_);
  entries_.reserve(most_edges(balls.count() + balls.infinite_count(), window.owned_count()));
  for (VertexId v = 0; v < window.owned_count(); ++v) {
    if (spacing[v] == kNoSample) poles_.forget(v);
  }
  add_facets(balls);
  add_poles(balls);
}

void WindowEvidence::add_facets(const StarBalls& balls) {
  const auto prepare = [&](CellId cell) {
    for (int side = 0; side < 4; ++side) {
      const CellId beyond = cells_.neighbor(cell, side);
      if (beyond > cell && nodes_.contains(beyond)) balls.prefetch(nodes_.position(beyond));
    }
    cells_.prefetch_points(cell);
  };
  nodes_.for_each(prepare, [&](CellId cell) {
    const RankedCell ranked(window_, cells_, cell);
    for (int apex = 0; apex < 4; ++apex) {
      if (!window_.owns(ranked.ranks[apex == 0 ? 1 : 0])) continue;
      const CellId beyond = cells_.neighbor(cell, ranked.sides[apex]);
      if (beyond > cell || !nodes_.contains(beyond)) add_facet(cell, ranked, apex, balls);
    }
  });
}

void WindowEvidence::add_facet(CellId cell, const RankedCell& ranked, int apex,
                               const StarBalls& balls) {
  std::array<VertexId, 3> v{};
  double spacing = 0;
  for (int i = 0, corner = 0; corner < 4; ++corner) {
    if (corner == apex) continue;
    v[i++] = ranked.vertices[corner];
    spacing = std::max(spacing, double{spacing_[ranked.vertices[corner]]});
  }
  const int side = ranked.sides[apex];
  const CellId beyond = cells_.neighbor(cell, side);
  FacetSides sides{.corners = {balls.between(v[0], v[1]), balls.between(v[0], v[2])},
                   .centres = {balls.from(v[0], nodes_.position(cell)), {}},
                   .is_hull = !nodes_.contains(beyond)};
  if (sides.is_hull) {
    const Point3 normal = cross(sides.corners[0], sides.corners[1]);
    sides.centres[1] = is_outward(cells_.facet(cell, side), v) ? normal : scaled(normal, -1);
  } else {
    sides.centres[1] = balls.from(v[0], nodes_.position(beyond));
  }
  entries_.push_back(
      {key_of(same_side_evidence(sides, spacing)), 4 * cell + static_cast<std::uint32_t>(side)});
}

void WindowEvidence::add_poles(const StarBalls& balls) {
  for (VertexId v = 0; v < window_.owned_count(); ++v) {
    if (!poles_.pair(v).is_complete()) continue;
    entries_.push_back({key_of(opposite_evidence(poles_.balls_of(v, balls), spacing_[v])), ~v});
  }
}

std::array<std::uint32_t, 3> WindowEvidence::tie(std::uint32_t name) const {
  if (is_pole_pair(name)) {
    const auto rank = static_cast<std::uint32_t>(window_.rank(sample_of(name)));
    return {rank, rank, rank};
  }
  const RankedFacet facet(window_, cells_.facet(name / 4, static_cast<int>(name % 4)));
  return {static_cast<std::uint32_t>(facet.ranks[0]), static_cast<std::uint32_t>(facet.ranks[1]),
          static_cast<std::uint32_t>(facet.ranks[2])};
}

EvidenceEdge WindowEvidence::edge(const Entry& entry) const {
  EvidenceEdge edge{.weight = std::bit_cast<float>(entry.key)};
  if (is_pole_pair(entry.name)) {
    const PolePair pair = poles_.pair(sample_of(entry.name));
    edge.a = pair.first == PolePair::kInfinity ? nodes_.count() : nodes_.position(pair.first);
    edge.b = nodes_.position(pair.second);
    edge.is_opposite = true;
  } else {
    const CellId cell = entry.name / 4;
    const CellId beyond = cells_.neighbor(cell, static_cast<int>(entry.name % 4));
    edge.a = nodes_.position(cell);
    edge.b = nodes_.contains(beyond) ? nodes_.position(beyond) : nodes_.count();
  }
  return edge;
}

// In the order of their weights, edges lie anywhere in memory. So what a block of them will ask for
// is on its way while the block before is at work. Few edges are left, and only they need a tie.
std::vector<EvidenceEdge> WindowEvidence::contract(SignedForest& forest,
                                                   std::uint64_t border_nodes) {
  sort();
  std::vector<EvidenceEdge> left;
  left.reserve(border_nodes);
  std::array<EvidenceEdge, kBlock> edges;
  const auto block = [this](std::size_t begin) {
    const std::size_t first = std::min(begin, entries_.size());
    return std::span(entries_).subspan(first, std::min(kBlock, entries_.size() - first));
  };
  for (std::size_t begin = 0; begin < entries_.size(); begin += kBlock) {
    for (const Entry& entry : block(begin + kBlock)) prefetch(entry.name);
    const std::span<const Entry> entries = block(begin);
    for (std::size_t i = 0; i < entries.size(); ++i) {
      edges[i] = edge(entries[i]);
      forest.prefetch(edges[i]);
    }
    for (std::size_t i = 0; i < entries.size(); ++i) {
      auto rest = forest.add(edges[i]);
      if (!rest) continue;
      rest->tie = tie(entries[i].name);
      left.push_back(*rest);
    }
  }
  entries_ = {};
  return left;
}

// On lattices most edges have one of a few weights.
void WindowEvidence::sort() {
  boost::sort::spreadsort::integer_sort(
      entries_.begin(), entries_.end(),
      [](const Entry& entry, unsigned bits) { return ~entry.key >> bits; },
      [](const Entry& x, const Entry& y) { return x.key > y.key; });
  for (std::size_t begin = 0; begin < entries_.size();) {
    std::size_t end = begin + 1;
    while (end < entries_.size() && entries_[end].key == entries_[begin].key) ++end;
    sort_equal(std::span(entries_).subspan(begin, end - begin));
    begin = end;
  }
}

// Many are sorted by the first rank of their ties, put in the place of the key, and ties are
// compared only of edges of one sample.
void WindowEvidence::sort_equal(std::span<Entry> entries) {
  constexpr std::size_t kFew = 8;
  const auto by_tie = [this](const Entry& x, const Entry& y) { return tie(x.name) < tie(y.name); };
  if (entries.size() <= kFew) {
    if (entries.size() > 1) std::sort(entries.begin(), entries.end(), by_tie);
    return;
  }
  const std::uint32_t key = entries.front().key;
  for (Entry& entry : entries) entry.key = tie(entry.name)[0];
  std::sort(entries.begin(), entries.end(), [&](const Entry& x, const Entry& y) {
    return x.key != y.key ? x.key < y.key : by_tie(x, y);
  });
  for (Entry& entry : entries) entry.key = key;
}

}  // namespace stream_recon
