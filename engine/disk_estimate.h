// The disk that a run will take, judged before the long work begins.
//
// Guarantees: on the high side for the clouds measured (docs/benchmarks.md), within a factor of
// about two; a cloud that compresses badly in every digit can take a little more.
// Thread rule: pure functions.
#pragma once

#include <cstdint>
#include <string>

#include "engine/reconstruct.h"

namespace stream_recon {

struct DiskEstimate {
  std::uint64_t scratch = 0;  ///< bytes at the peak
  std::uint64_t outputs = 0;
};

DiskEstimate estimate_disk(std::uint64_t points, const RunOptions& options);

/// What a person should know of it: one line with what is free where.
struct DiskOutlook {
  std::string text;
  bool is_short = false;  ///< there is less than the estimate, or the limit is lower
};

/// \param scratch_bytes that the run has there already
DiskOutlook disk_outlook(const DiskEstimate& estimate, const RunOptions& options,
                         std::uint64_t scratch_bytes);

}  // namespace stream_recon
