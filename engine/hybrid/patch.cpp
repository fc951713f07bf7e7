#include "engine/hybrid/patch.h"

#include <algorithm>
#include <utility>

#include "engine/hybrid/crust_mesh.h"
#include "engine/hybrid/enclosed_region.h"
#include "engine/hybrid/hole_rings.h"
#include "engine/hybrid/patch_check.h"
#include "spatial/ring_triangulation.h"
#include "spatial/vector.h"

namespace stream_recon {
namespace {

using Rings = std::vector<std::vector<std::uint32_t>>;

double area_of(const Hole& hole, const std::vector<HoleTriangle>& triangles) {
  double twice = 0;
  for (const HoleTriangle& t : triangles) {
    const Point3& a = hole.points[t[0]];
    twice += length(cross(minus(hole.points[t[1]], a), minus(hole.points[t[2]], a)));
  }
  return twice / 2;
}

std::uint32_t point_count(const Hole& hole) {
  return static_cast<std::uint32_t>(hole.points.size());
}

std::optional<Patch> patch_of(PatchKind kind, const Hole& hole, const Rings& rings,
                              std::vector<HoleTriangle> triangles) {
  if (triangles.empty() || !fits_rings(triangles, point_count(hole), rings)) return std::nullopt;
  const std::uint32_t unused = unused_points(triangles, point_count(hole));
  return Patch{kind, std::move(triangles), unused};
}

std::optional<Patch> cut_from(const CrustMesh& crust, const Hole& hole, const Rings& rings,
                              const PatchOptions& options) {
  auto walks = walk_rings(hole, rings, crust, options.walk);
  if (!walks) return std::nullopt;
  const auto region = enclosed_region(crust, walks->is_walked);
  if (!region) return std::nullopt;
  auto merged = merged_patch(hole, crust, *region, std::move(walks->sample_of), options.merge);
  if (!merged) return std::nullopt;
  if (area_of(hole, *merged) > options.most_area * area_of(hole, hole.fills)) return std::nullopt;
  return patch_of(PatchKind::kCrust, hole, rings, std::move(*merged));
}

/// Inner edges of the fills, from the lower corner, in order.
std::vector<HoleEdge> fill_edges(const Hole& hole) {
  std::vector<HoleEdge> edges;
  for (const HoleTriangle& fill : hole.fills) {
    for (std::size_t i = 0; i < 3; ++i) {
      const auto [low, high] = std::minmax(fill[i], fill[(i + 1) % 3]);
      edges.push_back({low, high});
    }
  }
  std::sort(edges.begin(), edges.end());
  return edges;
}

std::optional<Patch> close_ring(const Hole& hole, const Rings& rings) {
  if (rings.size() != 1) return std::nullopt;
  const auto& ring = rings.front();
  if (ring.size() < 3 || ring.size() > kMostRingEdges || ring.size() != hole.points.size()) {
    return std::nullopt;
  }
  std::vector<Point3> points;
  for (const std::uint32_t v : ring) points.push_back(hole.points[v]);
  const std::vector<HoleEdge> known = fill_edges(hole);
  std::vector<HoleTriangle> triangles;
  for (const auto& t : ring_triangulation(points, [&](std::uint32_t from, std::uint32_t to) {
         const auto [low, high] = std::minmax(ring[from], ring[to]);
         return std::binary_search(known.begin(), known.end(), HoleEdge{low, high});
       })) {
    triangles.push_back({ring[t[0]], ring[t[1]], ring[t[2]]});
  }
  // A vertex that the ring passes twice does not get through this.
  return patch_of(PatchKind::kTriangles, hole, rings, std::move(triangles));
}

}  // namespace

Patch make_patch(const Hole& hole, const CrustPiece& crust, const PatchOptions& options) {
  const Rings rings = hole_rings(hole);
  if (!rings.empty()) {
    CrustMesh mesh(crust);
    for (int subdivisions = 0;; ++subdivisions) {
      if (auto patch = cut_from(mesh, hole, rings, options)) return std::move(*patch);
      if (subdivisions >= options.most_subdivisions) break;
      mesh = CrustMesh(mesh.subdivided());
    }
    if (auto patch = close_ring(hole, rings)) return std::move(*patch);
  }
  return {PatchKind::kNone, {}, point_count(hole)};
}

std::optional<Patch> close_by_triangles(const Hole& hole) {
  return close_ring(hole, hole_rings(hole));
}

}  // namespace stream_recon
