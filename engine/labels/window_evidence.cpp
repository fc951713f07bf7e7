#include "engine/labels/window_evidence.h"

#include <algorithm>
#include <bit>
#include <cassert>

#include "engine/windows/final_simplices.h"

namespace stream_recon {
namespace {

/// Bits of floats that are not negative are ordered as the floats are.
std::uint32_t key_of(double weight) {
  return std::bit_cast<std::uint32_t>(static_cast<float>(weight));
}

}  // namespace

WindowEvidence::WindowEvidence(const FinalWindow& window, std::span<const float> spacing)
    : window_(window),
      cells_(window.delaunay().view()),
      spacing_(spacing),
      poles_(window),
      first_pair_name_(~(window.owned_count() - 1)) {
  assert(4 * std::uint64_t{cells_.slots()} < first_pair_name_);
  entries_.reserve(most_edges(count_cells(), window.owned_count()));
  add_facets();
  add_poles();
}

std::uint64_t WindowEvidence::count_cells() const {
  std::uint64_t count = 0;
  for (CellId cell = 0; cell < cells_.slots(); ++cell) {
    if (!cells_.is_live(cell)) continue;
    const auto v = cells_.vertices(cell);
    count += window_.owns_vertex(std::min(std::min(v[0], v[1]), std::min(v[2], v[3]))) ? 1 : 0;
  }
  return count;
}

void WindowEvidence::add_facets() {
  for_each_final_facet(window_, {0, cells_.slots()}, [this](CellId cell, int side) {
    const RankedFacet facet(window_, cells_.facet(cell, side));
    const double weight = same_side_evidence(balls(facet, cell, side), spacing(facet));
    entries_.push_back({key_of(weight), 4 * cell + static_cast<std::uint32_t>(side)});
  });
}

void WindowEvidence::add_poles() {
  for (VertexId v = 0; v < window_.owned_count(); ++v) {
    const PolePair pair = poles_.pair(v);
    if (!pair.is_complete()) continue;
    entries_.push_back({key_of(opposite_evidence(pair.balls, spacing_[v])), ~v});
  }
}

FacetBalls WindowEvidence::balls(const RankedFacet& facet, CellId cell, int side) const {
  const std::array<Point3, 3> corners{cells_.point(facet.vertices[0]),
                                      cells_.point(facet.vertices[1]),
                                      cells_.point(facet.vertices[2])};
  const Point3 apex = cells_.point(cells_.vertex(cell, side));
  const CellId beyond = cells_.neighbor(cell, side);
  if (cells_.is_infinite(beyond)) return hull_facet_balls(corners, apex);
  const int mirror = cells_.mirror_index(cell, side);
  return facet_balls(corners, apex, cells_.point(cells_.vertex(beyond, mirror)));
}

double WindowEvidence::spacing(const RankedFacet& facet) const {
  return std::max(std::max(spacing_[facet.vertices[0]], spacing_[facet.vertices[1]]),
                  spacing_[facet.vertices[2]]);
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
    edge.a = pair.first == PolePair::kInfinity ? infinite_node() : pair.first;
    edge.b = pair.second;
    edge.is_opposite = true;
  } else {
    const CellId cell = entry.name / 4;
    edge.a = cell;
    edge.b = node(cells_.neighbor(cell, static_cast<int>(entry.name % 4)));
  }
  return edge;
}

// Few edges are left, and only they need a tie.
std::vector<EvidenceEdge> WindowEvidence::contract(SignedForest& forest,
                                                   std::uint64_t border_nodes) {
  sort();
  std::vector<EvidenceEdge> edges;
  edges.reserve(border_nodes);
  for (const Entry& entry : entries_) {
    auto left = forest.add(edge(entry));
    if (!left) continue;
    left->tie = tie(entry.name);
    edges.push_back(*left);
  }
  entries_ = {};
  return edges;
}

// On lattices most edges have one of a few weights. So equal ones are sorted by the first rank of
// their ties, put in the place of the key, and ties are compared only of edges of one sample.
void WindowEvidence::sort() {
  std::sort(entries_.begin(), entries_.end(),
            [](const Entry& x, const Entry& y) { return x.key > y.key; });
  const auto end_of_run = [this](std::size_t begin) {
    std::size_t end = begin + 1;
    while (end < entries_.size() && entries_[end].key == entries_[begin].key) ++end;
    return end;
  };
  for (std::size_t begin = 0; begin < entries_.size();) {
    const std::size_t end = end_of_run(begin);
    const std::uint32_t key = entries_[begin].key;
    const std::span run(entries_.data() + begin, end - begin);
    constexpr std::size_t kFew = 8;
    if (run.size() > 1 && run.size() <= kFew) {
      std::sort(run.begin(), run.end(),
                [this](const Entry& x, const Entry& y) { return tie(x.name) < tie(y.name); });
    } else if (run.size() > kFew) {
      for (Entry& entry : run) entry.key = tie(entry.name)[0];
      std::sort(run.begin(), run.end(), [this](const Entry& x, const Entry& y) {
        return x.key != y.key ? x.key < y.key : tie(x.name) < tie(y.name);
      });
      for (Entry& entry : run) entry.key = key;
    }
    begin = end;
  }
}

}  // namespace stream_recon
