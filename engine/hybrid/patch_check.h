// Whether triangles fit a hole.
//
// Thread rule: pure. Cost: n log n.
#pragma once

#include <cstdint>
#include <vector>

#include "engine/hybrid/hole.h"

namespace stream_recon {

/// Every edge of the rings has one triangle, at its left, and every other edge one at either side;
/// no triangle is there twice, none with a corner twice or out of range.
bool fits_rings(const std::vector<HoleTriangle>& triangles, std::uint32_t point_count,
                const std::vector<std::vector<std::uint32_t>>& rings);

/// Points of the hole that no triangle has.
std::uint32_t unused_points(const std::vector<HoleTriangle>& triangles, std::uint32_t point_count);

}  // namespace stream_recon
