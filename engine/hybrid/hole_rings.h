// The border of a hole, in rings.
//
// Guarantees: every border edge is in one ring, once; no ring crosses itself. Rings start at their
// lowest edge and come in that order. Thread rule: pure. Memory: 28 bytes a fill and side. Cost:
// n log n.
#pragma once

#include <cstdint>
#include <vector>

#include "engine/hybrid/hole.h"

namespace stream_recon {

/// The directed border edges of the fills (those without an opposite one in the hole; the hole lies
/// at their left), joined to rings: at a vertex with several (figure eight) each edge goes on with
/// the one that bounds the same fan of fills.
/// \return vertices of each ring in order
std::vector<std::vector<std::uint32_t>> hole_rings(const Hole& hole);

}  // namespace stream_recon
