#include "engine/hybrid/patch_check.h"

#include <algorithm>
#include <cstddef>

namespace stream_recon {
namespace {

/// An edge from its lower corner, and what it is used for.
struct EdgeUse {
  HoleEdge edge{};
  int triangles = 0;
  int turns = 0;  ///< triangles up less triangles down, less the same of the rings
  int rings = 0;
  int fills = 0;
  int outer = 0;  ///< facets outside the hole
};

EdgeUse outer_use(const HoleEdge& edge) {
  return {edge, 0, 0, 0, 0, 1};
}

EdgeUse fill_use(std::uint32_t from, std::uint32_t to) {
  return {{std::min(from, to), std::max(from, to)}, 0, 0, 0, 1, 0};
}

EdgeUse triangle_use(std::uint32_t from, std::uint32_t to) {
  return {{std::min(from, to), std::max(from, to)}, 1, from < to ? 1 : -1, 0, 0, 0};
}

EdgeUse ring_use(std::uint32_t from, std::uint32_t to) {
  return {{std::min(from, to), std::max(from, to)}, 0, from < to ? -1 : 1, 1, 0, 0};
}

/// The uses of one edge, added up: as a manifold, the border of which is the ring.
bool is_in_order(const EdgeUse& sum) {
  const int inner = sum.outer > 0 ? 0 : 2;
  const int most = std::max(sum.rings > 0 ? sum.rings : inner, sum.fills);
  return sum.turns == 0 && sum.triangles <= most;
}

void add_twins(const std::vector<HoleTriangle>& triangles, const Hole& hole,
               std::vector<HoleEdge>& found) {
  std::vector<HoleTriangle> sorted = triangles;
  sorted.insert(sorted.end(), hole.outer_facets.begin(), hole.outer_facets.end());
  for (HoleTriangle& t : sorted) std::sort(t.begin(), t.end());
  std::sort(sorted.begin(), sorted.end());
  for (std::size_t i = 1; i < sorted.size(); ++i) {
    const HoleTriangle& t = sorted[i];
    if (t == sorted[i - 1]) found.insert(found.end(), {{t[0], t[1]}, {t[1], t[2]}, {t[0], t[2]}});
  }
}

std::vector<EdgeUse> edge_uses(const std::vector<HoleTriangle>& triangles, const Hole& hole,
                               const std::vector<std::vector<std::uint32_t>>& rings) {
  std::vector<EdgeUse> uses;
  for (const HoleTriangle& t : triangles) {
    for (std::size_t i = 0; i < 3; ++i) uses.push_back(triangle_use(t[i], t[(i + 1) % 3]));
  }
  for (const HoleTriangle& t : hole.fills) {
    for (std::size_t i = 0; i < 3; ++i) uses.push_back(fill_use(t[i], t[(i + 1) % 3]));
  }
  for (const HoleEdge& edge : hole.outer_edges) uses.push_back(outer_use(edge));
  for (const auto& ring : rings) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      uses.push_back(ring_use(ring[i], ring[(i + 1) % ring.size()]));
    }
  }
  std::sort(uses.begin(), uses.end(),
            [](const EdgeUse& a, const EdgeUse& b) { return a.edge < b.edge; });
  return uses;
}

}  // namespace

std::vector<HoleEdge> misfits(const std::vector<HoleTriangle>& triangles, const Hole& hole,
                              const std::vector<std::vector<std::uint32_t>>& rings) {
  std::vector<HoleEdge> found;
  add_twins(triangles, hole, found);
  const std::vector<EdgeUse> uses = edge_uses(triangles, hole, rings);
  for (std::size_t first = 0; first < uses.size();) {
    EdgeUse sum{uses[first].edge};
    for (; first < uses.size() && uses[first].edge == sum.edge; ++first) {
      sum.triangles += uses[first].triangles;
      sum.turns += uses[first].turns;
      sum.rings += uses[first].rings;
      sum.fills += uses[first].fills;
      sum.outer += uses[first].outer;
    }
    if (!is_in_order(sum)) found.push_back(sum.edge);
  }
  return found;
}

std::uint32_t unused_points(const std::vector<HoleTriangle>& triangles, std::uint32_t point_count) {
  std::vector<bool> is_used(point_count);
  for (const HoleTriangle& t : triangles) {
    for (const std::uint32_t corner : t) is_used[corner] = true;
  }
  return static_cast<std::uint32_t>(std::count(is_used.begin(), is_used.end(), false));
}

}  // namespace stream_recon
