// Walks on the crust along the rings of a hole, edge by edge.
//
// Each ring vertex gets a vertex of the crust, the nearest that faces the same way; the walk of a
// ring edge goes between two of them over edges of the crust, the shorter and the nearer to the
// ring edge the better. Guarantees: no vertex of the crust is on two walks, but at their ends; each
// vertex on a walk belongs to one end of its ring edge, and they switch once. So the walks map to
// the rings. Thread rule: pure. Memory: 24 bytes a vertex, 12 a
// triangle of the crust. Cost: a few hundred
// vertices an edge of the rings.
// Source: thesis, 2007, chapter 6, which walks across triangles by a plane test; over edges the
// walk adds no vertices and bounds whole triangles.
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "engine/hybrid/crust_mesh.h"
#include "engine/hybrid/hole.h"

namespace stream_recon {

inline constexpr std::uint32_t kNoHolePoint = std::numeric_limits<std::uint32_t>::max();
inline constexpr std::uint32_t kNoEdge = std::numeric_limits<std::uint32_t>::max();

struct RingWalkOptions {
  double straightness = 2;          ///< how much a walk is longer for going beside the ring edge
  std::uint32_t most_seen = 20000;  ///< vertices of the crust looked at for a ring edge
};

struct RingWalks {
  std::vector<HoleEdge> edges;            ///< of the rings
  std::vector<std::uint32_t> sample_of;   ///< of each vertex of the crust, or kNoHolePoint
  std::vector<std::uint32_t> walked_for;  ///< of each side of the crust, in the ring's direction:
                                          ///< the edge of the rings, or kNoEdge
  std::vector<HoleEdge> failed;           ///< edges without a walk
};

RingWalks walk_rings(const Hole& hole, const std::vector<std::vector<std::uint32_t>>& rings,
                     const CrustMesh& crust, const RingWalkOptions& options = {});

}  // namespace stream_recon
