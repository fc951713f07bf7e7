// Triangles over a closed ring of points, without others: as few foreign edges, then as little area
// as can be.
//
// Guarantees: n - 2 triangles, each edge of the ring in one of them in the ring's direction, each
// inner edge in two; of several best ones always the same. No claim about crossings in space.
// Thread rule: pure. Memory: 20 n^2 bytes. Cost: about n^3 / 6 triangle areas.
// Source: Klincsek, Minimal triangulations of polygonal domains, 1980; Barequet, Sharir, Filling
// gaps in the boundary of a polyhedron, 1995.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "spatial/point.h"

namespace stream_recon {

/// Whether an inner edge between two places of the ring, the first the lower one, is welcome.
using IsWelcome = std::function<bool(std::uint32_t, std::uint32_t)>;

/// \param ring at least three points in order
/// \return places in the ring
std::vector<std::array<std::uint32_t, 3>> ring_triangulation(std::span<const Point3> ring,
                                                             const IsWelcome& is_welcome = {});

}  // namespace stream_recon
