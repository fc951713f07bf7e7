// Which labels a volume has, and where each of them lies.
//
// Memory: one slice, 64 bytes a label. Cost: one pass. Thread rule: pure function.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "tools/sampling/grid.h"

namespace stream_recon {

struct LabelExtent {
  double label = 0;
  std::uint64_t cells = 0;
  GridBox box;
};

/// All labels but 0, ascending; cells that are not finite have none.
/// \throw InputError a voxel that is no whole number, or more than 65,536 of them: no label volume
std::vector<LabelExtent> find_labels(Grid& grid);

/// "1 to 15, 18, 29": for messages; cut after a few.
std::string label_list(const std::vector<LabelExtent>& labels);

}  // namespace stream_recon
