// What must hold of a regular triangulation, checked with the exact predicates from outside.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <vector>

#include "spatial/cell_view.h"
#include "spatial/predicates.h"
#include "spatial/regular_triangulation.h"

namespace stream_recon::regular_check {

using Tetrahedron = std::array<VertexId, 4>;
using Sites = std::vector<WeightedPoint3>;

inline Predicates predicates_for(const Sites& sites) {
  CoordinateRange range;
  for (const WeightedPoint3& site : sites) range.extend(site);
  return Predicates(range);
}

/// The finite cells, each sorted, named by positions in the inserted order or by `names` of them.
inline std::set<Tetrahedron> tetrahedra(const RegularTriangulation& regular,
                                        const std::vector<VertexId>& names = {}) {
  std::set<Tetrahedron> cells;
  for (CellId c = 0; c < regular.cell_slots(); ++c) {
    if (!regular.is_live(c) || regular.is_infinite(c)) continue;
    Tetrahedron t = regular.vertices(c);
    for (VertexId& v : t) v = names.empty() ? v : names[v];
    std::sort(t.begin(), t.end());
    EXPECT_TRUE(cells.insert(t).second) << "a cell appears twice";
  }
  return cells;
}

/// False for the lighter ones of sites at one place, and for later ones of equal sites.
inline std::vector<bool> wins_at_its_place(const Sites& sites) {
  std::map<Point3, std::size_t> best;
  for (std::size_t i = 0; i < sites.size(); ++i) {
    const auto [at, is_new] = best.insert({sites[i].point, i});
    if (!is_new && sites[i].weight > sites[at->second].weight) at->second = i;
  }
  std::vector<bool> wins(sites.size(), false);
  for (const auto& [place, i] : best) wins[i] = true;
  return wins;
}

/// All tetrahedra whose perturbed orthogonal sphere no site is closer to than orthogonal.
/// \param sites in the safe range of the predicates. Cost: n^5.
inline std::set<Tetrahedron> brute_force(const Sites& sites) {
  const Predicates exact = predicates_for(sites);
  const std::vector<bool> wins = wins_at_its_place(sites);
  const auto n = static_cast<VertexId>(sites.size());
  std::set<Tetrahedron> cells;
  const auto is_empty = [&](Tetrahedron t, int orientation) {
    if (orientation < 0) std::swap(t[0], t[1]);
    for (VertexId q = 0; q < n; ++q) {
      if (!wins[q] || std::find(t.begin(), t.end(), q) != t.end()) continue;
      if (exact.power_test_perturbed(sites[t[0]], sites[t[1]], sites[t[2]], sites[t[3]], sites[q]) >
          0) {
        return false;
      }
    }
    return true;
  };
  for (VertexId i = 0; i < n; ++i) {
    for (VertexId j = i + 1; j < n; ++j) {
      for (VertexId k = j + 1; k < n; ++k) {
        for (VertexId l = k + 1; l < n; ++l) {
          if (!(wins[i] && wins[j] && wins[k] && wins[l])) continue;
          const int orientation =
              exact.orient3d(sites[i].point, sites[j].point, sites[k].point, sites[l].point);
          const Tetrahedron t{i, j, k, l};
          if (orientation != 0 && is_empty(t, orientation)) cells.insert(t);
        }
      }
    }
  }
  return cells;
}

/// Whether a site is in conflict with cell c, finite or not.
inline bool in_conflict(const WeightedCellView& cells, const Sites& sites, const Predicates& exact,
                        CellId c, const WeightedPoint3& q) {
  const Tetrahedron t = cells.vertices(c);
  const WeightedPoint3& a = sites[t[0]];
  const WeightedPoint3& b = sites[t[1]];
  const WeightedPoint3& d = sites[t[2]];
  if (!cells.is_infinite(c)) return exact.power_test_perturbed(a, b, d, sites[t[3]], q) > 0;
  const int side = exact.orient3d(a.point, b.point, d.point, q.point);
  return side != 0 ? side > 0 : exact.power_circle_perturbed(a, b, d, q) > 0;
}

/// Facets are shared both ways, cells are positively oriented and locally regular.
inline void expect_cell_valid(const WeightedCellView& cells, const Sites& sites,
                              const Predicates& exact, CellId c) {
  const Tetrahedron t = cells.vertices(c);
  if (!cells.is_infinite(c)) {
    ASSERT_GT(
        exact.orient3d(sites[t[0]].point, sites[t[1]].point, sites[t[2]].point, sites[t[3]].point),
        0)
        << "cell " << c;
  }
  for (int i = 0; i < 4; ++i) {
    const CellId beyond = cells.neighbor(c, i);
    const int back = cells.mirror_index(c, i);
    ASSERT_TRUE(cells.is_live(beyond)) << "cell " << c << " borders a dead cell";
    ASSERT_EQ(cells.neighbor(beyond, back), c);
    auto ours = cells.facet(c, i);
    auto theirs = cells.facet(beyond, back);
    std::sort(ours.begin(), ours.end());
    std::sort(theirs.begin(), theirs.end());
    ASSERT_EQ(ours, theirs) << "cell " << c << " and its neighbor " << i;
    const VertexId across = cells.vertex(beyond, back);
    if (across == RegularTriangulation::kInfinite) continue;
    ASSERT_FALSE(in_conflict(cells, sites, exact, c, sites[across])) << "cell " << c;
  }
}

/// Cells tile space and the half-spaces around the hull and are locally regular, which together
/// imply that they are the regular triangulation of their vertices; all others are hidden.
/// \param sites in the safe range of the predicates
inline void expect_valid(const RegularTriangulation& regular, const Sites& sites) {
  const Predicates exact = predicates_for(sites);
  const WeightedCellView cells = regular.view();
  std::set<std::array<VertexId, 2>> edges;
  std::set<VertexId> used;
  std::size_t live = 0;
  for (CellId c = 0; c < cells.slots(); ++c) {
    if (!cells.is_live(c)) continue;
    ++live;
    ASSERT_NO_FATAL_FAILURE(expect_cell_valid(cells, sites, exact, c));
    const Tetrahedron t = cells.vertices(c);
    for (int i = 0; i < 4; ++i) {
      used.insert(t[i]);
      for (int j = i + 1; j < 4; ++j) edges.insert({std::min(t[i], t[j]), std::max(t[i], t[j])});
    }
  }
  // Euler's relation of the 3-sphere, with two cells a facet; the infinite vertex counts.
  EXPECT_EQ(used.size() + live, edges.size());
  ASSERT_EQ(regular.site_count(), sites.size());
  EXPECT_EQ(regular.hidden_count() + used.size(), sites.size() + 1);
  for (VertexId v = 0; v < sites.size(); ++v) ASSERT_NE(regular.is_hidden(v), used.contains(v));
}

}  // namespace stream_recon::regular_check
