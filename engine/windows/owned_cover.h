// Boxes that stand for the owned points of a window where distances to them are asked for.
//
// Guarantees: every owned point is in a box; at most kMostCoverBoxes + 15 boxes. The largest are
// divided first, down to single points: where a run of the curve jumps, one box around it would
// make half of the cloud a neighbour.
// Thread rule: pure but for the reader. Cost: some 300 looks at the index.
#pragma once

#include <cstddef>
#include <vector>

#include "engine/windows/index_reader.h"
#include "engine/windows/owned_range.h"

namespace stream_recon {

inline constexpr std::size_t kMostCoverBoxes = 256;

/// \throw IoError
std::vector<NodeBounds> cover_owned(const CloudIndex& index, IndexReader& reader,
                                    const OwnedRange& owned);

}  // namespace stream_recon
