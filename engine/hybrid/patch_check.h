// Whether triangles fit a hole.
//
// Thread rule: pure. Memory: 20 bytes a side. Cost: n log n.
#pragma once

#include <cstdint>
#include <vector>

#include "engine/hybrid/hole.h"

namespace stream_recon {

/// They fit if every edge of the rings has one triangle, at its left, every other edge one at
/// either side, or no more than the fills have there (as many
/// as they where facets outside have the edge), and no three corners have two triangles, or one
/// and a facet outside.
/// \return the edges where they do not, from the lower corner, some more than once
std::vector<HoleEdge> misfits(const std::vector<HoleTriangle>& triangles, const Hole& hole,
                              const std::vector<std::vector<std::uint32_t>>& rings);

/// Points of the hole that no triangle has.
std::uint32_t unused_points(const std::vector<HoleTriangle>& triangles, std::uint32_t point_count);

}  // namespace stream_recon
