// What must hold of a Delaunay structure, checked with the exact predicates from outside.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <set>
#include <vector>

#include "spatial/delaunay.h"
#include "spatial/predicates.h"
#include "spatial/simplex_digest.h"

namespace stream_recon::delaunay_check {

using Tetrahedron = std::array<VertexId, 4>;

/// The cloud moved by a power of two to where the predicates are exact.
struct SafeCloud {
  std::vector<Point3> points;
  Predicates predicates;
};

inline SafeCloud make_safe(const std::vector<Point3>& points) {
  CoordinateRange range;
  for (const Point3& p : points) range.extend(p);
  const double scale = range.scale().value();
  std::vector<Point3> scaled;
  CoordinateRange safe;
  for (const Point3& p : points) {
    scaled.push_back({p.x * scale, p.y * scale, p.z * scale});
    safe.extend(scaled.back());
  }
  return {std::move(scaled), Predicates(safe)};
}

inline Tetrahedron sorted(Tetrahedron t) {
  std::sort(t.begin(), t.end());
  return t;
}

/// The finite cells, each sorted, named by positions in the inserted order or by `names` of them.
inline std::set<Tetrahedron> tetrahedra(const Delaunay& delaunay,
                                        const std::vector<VertexId>& names = {}) {
  std::set<Tetrahedron> cells;
  for (CellId c = 0; c < delaunay.cell_slots(); ++c) {
    if (!delaunay.is_live(c) || delaunay.is_infinite(c)) continue;
    Tetrahedron t = delaunay.vertices(c);
    for (VertexId& v : t) v = names.empty() ? v : names[v];
    EXPECT_TRUE(cells.insert(sorted(t)).second) << "a cell appears twice";
  }
  return cells;
}

inline SimplexDigest digest(const Delaunay& delaunay) {
  SimplexDigest sum;
  for (CellId c = 0; c < delaunay.cell_slots(); ++c) {
    if (!delaunay.is_live(c) || delaunay.is_infinite(c)) continue;
    const Tetrahedron t = delaunay.vertices(c);
    sum.add<4>({t[0], t[1], t[2], t[3]});
  }
  return sum;
}

/// All tetrahedra of the cloud with an empty perturbed circumsphere. Cost: n^5.
inline std::set<Tetrahedron> brute_force(const std::vector<Point3>& points) {
  const SafeCloud cloud = make_safe(points);
  const auto n = static_cast<VertexId>(points.size());
  std::set<Tetrahedron> cells;
  const auto is_empty = [&](const Tetrahedron& t, int orientation) {
    const Point3& a = cloud.points[t[orientation > 0 ? 0 : 1]];
    const Point3& b = cloud.points[t[orientation > 0 ? 1 : 0]];
    for (VertexId q = 0; q < n; ++q) {
      if (std::find(t.begin(), t.end(), q) != t.end()) continue;
      if (cloud.predicates.in_sphere_perturbed(a, b, cloud.points[t[2]], cloud.points[t[3]],
                                               cloud.points[q]) > 0) {
        return false;
      }
    }
    return true;
  };
  for (VertexId i = 0; i < n; ++i) {
    for (VertexId j = i + 1; j < n; ++j) {
      for (VertexId k = j + 1; k < n; ++k) {
        for (VertexId l = k + 1; l < n; ++l) {
          const Tetrahedron t{i, j, k, l};
          const int orientation = cloud.predicates.orient3d(cloud.points[i], cloud.points[j],
                                                            cloud.points[k], cloud.points[l]);
          if (orientation != 0 && is_empty(t, orientation)) cells.insert(t);
        }
      }
    }
  }
  return cells;
}

/// Whether point q is in conflict with cell c, finite or not.
inline bool in_conflict(const Delaunay& delaunay, const SafeCloud& cloud, CellId c,
                        const Point3& q) {
  const Tetrahedron t = delaunay.vertices(c);
  const auto& p = cloud.points;
  if (t[3] != Delaunay::kInfinite) {
    return cloud.predicates.in_sphere_perturbed(p[t[0]], p[t[1]], p[t[2]], p[t[3]], q) > 0;
  }
  const int side = cloud.predicates.orient3d(p[t[0]], p[t[1]], p[t[2]], q);
  if (side != 0) return side > 0;
  return cloud.predicates.in_circle_perturbed(p[t[0]], p[t[1]], p[t[2]], q) > 0;
}

/// The corner of `neighbor` that is not in the facet of cell c opposite its vertex i.
inline VertexId mirror_vertex(const Delaunay& delaunay, CellId c, int i) {
  const Tetrahedron own = delaunay.vertices(c);
  for (const VertexId v : delaunay.vertices(delaunay.neighbor(c, i))) {
    if (std::find(own.begin(), own.end(), v) == own.end()) return v;
  }
  ADD_FAILURE() << "cell " << c << " and its neighbor " << i << " have the same vertices";
  return Delaunay::kInfinite;
}

inline void expect_neighbors_agree(const Delaunay& delaunay, CellId c) {
  const Tetrahedron own = delaunay.vertices(c);
  for (int i = 0; i < 4; ++i) {
    const CellId n = delaunay.neighbor(c, i);
    ASSERT_LT(n, delaunay.cell_slots());
    ASSERT_TRUE(delaunay.is_live(n)) << "cell " << c << " borders a dead cell";
    const Tetrahedron other = delaunay.vertices(n);
    int shared = 0;
    int back = 0;
    for (int j = 0; j < 4; ++j) {
      shared += j != i && std::find(other.begin(), other.end(), own[j]) != other.end();
      back += delaunay.neighbor(n, j) == c;
    }
    ASSERT_EQ(shared, 3) << "cell " << c << " and its neighbor " << i << " share no facet";
    ASSERT_GE(back, 1) << "cell " << c << " is not a neighbor of its neighbor " << i;
  }
}

/// Cells tile space and the half-spaces around the hull, are positively oriented and locally
/// Delaunay, which together imply that they are Delaunay.
inline void expect_valid(const Delaunay& delaunay, const std::vector<Point3>& points) {
  const SafeCloud cloud = make_safe(points);
  const auto& p = cloud.points;
  ASSERT_EQ(delaunay.vertex_count(), points.size());
  std::set<std::array<VertexId, 2>> edges;
  std::set<VertexId> used;
  std::size_t live = 0;
  std::size_t finite = 0;
  for (CellId c = 0; c < delaunay.cell_slots(); ++c) {
    if (!delaunay.is_live(c)) continue;
    ++live;
    const Tetrahedron t = delaunay.vertices(c);
    ASSERT_EQ(delaunay.is_infinite(c), t[3] == Delaunay::kInfinite);
    for (int i = 0; i < 4; ++i) {
      used.insert(t[i]);
      for (int j = i + 1; j < 4; ++j) edges.insert({std::min(t[i], t[j]), std::max(t[i], t[j])});
    }
    if (!delaunay.is_infinite(c)) {
      ++finite;
      ASSERT_GT(cloud.predicates.orient3d(p[t[0]], p[t[1]], p[t[2]], p[t[3]]), 0) << "cell " << c;
    }
    ASSERT_NO_FATAL_FAILURE(expect_neighbors_agree(delaunay, c));
    for (int i = 0; i < 4; ++i) {
      const VertexId across = mirror_vertex(delaunay, c, i);
      if (across == Delaunay::kInfinite) continue;
      ASSERT_FALSE(in_conflict(delaunay, cloud, c, p[across])) << "cell " << c << " facet " << i;
    }
  }
  EXPECT_EQ(finite, delaunay.finite_cell_count());
  // Every point and the infinite vertex; Euler's relation of the 3-sphere, with two cells a facet.
  EXPECT_EQ(used.size(), points.size() + 1);
  EXPECT_EQ(used.size() + live, edges.size());
}

}  // namespace stream_recon::delaunay_check
