#include "engine/hybrid/patch.h"

#include <algorithm>
#include <utility>

#include "engine/hybrid/cut_patch.h"
#include "engine/hybrid/hole_rings.h"
#include "engine/hybrid/patch_check.h"
#include "spatial/ring_triangulation.h"

namespace stream_recon {
namespace {

using Rings = std::vector<std::vector<std::uint32_t>>;

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
  // An edge twice, of a ring that passes a vertex twice.
  if (!misfits(triangles, hole, rings).empty()) return std::nullopt;
  return Patch{PatchKind::kTriangles, std::move(triangles)};
}

}  // namespace

Patch make_patch(const Hole& hole, const CrustPiece& crust, const PatchOptions& options) {
  const Rings rings = hole_rings(hole);
  if (!rings.empty()) {
    if (auto patch = cut_patch(hole, rings, crust, options)) return std::move(*patch);
    if (auto patch = close_ring(hole, rings)) return std::move(*patch);
  }
  return {PatchKind::kNone, {}, static_cast<std::uint32_t>(hole.points.size())};
}

std::optional<Patch> close_by_triangles(const Hole& hole) {
  return close_ring(hole, hole_rings(hole));
}

}  // namespace stream_recon
