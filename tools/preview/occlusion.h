// How much of the sky each point of a depth buffer sees: crevices and the inside of holes get dark.
//
// Guarantees: a function of the cells alone. Memory: 4 bytes a cell. Cost: up to 128 depth look-ups
// a cell. Source: Bavoil, Sainz, Dimitrov, SIGGRAPH 2008 (horizon-based).
#pragma once

#include <vector>

#include "tools/preview/cells.h"

namespace stream_recon {

/// Row by row from below: 1 in the open, 0 buried; 1 where there is nothing.
std::vector<float> sky_visibility(const Cells& cells);

}  // namespace stream_recon
