// The stretch of ranks that a window owns.
//
// Thread rule: a value.
#pragma once

#include <cstdint>

#include "engine/windows/final_window.h"

namespace stream_recon {

struct OwnedRange {
  PointRank first = 0;  ///< a multiple of 16, so that leaves are owned whole
  std::uint64_t count = 0;

  PointRank end() const { return first + count; }
};

}  // namespace stream_recon
