// The crust near holes: built at their samples only, and sorted by hole.
//
// Guarantees: a hole gets every face of the crust between poles that were chosen, one corner of
// which is named by one of its samples; the file is a function of the poles and the holes alone.
// Thread rule: one caller; windows side by side. Memory: as crust/crust_windows.h; then a sort of
// 136 bytes a triangle and hole, or as much as there is.
#pragma once

#include "engine/crust/crust_windows.h"
#include "engine/hybrid/hole_samples.h"
#include "engine/order/ingest.h"
#include "engine/stage_context.h"

namespace stream_recon {

/// Name of the file of HoleCrust in the scratch directory.
inline constexpr const char* kHoleCrust = "hole_crust";

struct HoleCrustOptions {
  const SampleChoice& choice;  ///< poles that touch one of these have their faces made
  unsigned threads = 1;
  std::uint64_t window_points = 0;  ///< samples of a window at most; 0: what the memory allows
};

struct HoleCrustResult {
  PowerTotals power;
  std::uint64_t most_triangles = 0;  ///< of one hole
};

/// \pre The pole store is in the scratch directory, and `cloud` has far
/// points. \throw IoError, BudgetError, InputError, Interrupted
HoleCrustResult build_hole_crust(const CloudSummary& cloud, std::uint64_t point_count,
                                 const HoleSamples& samples, const HoleCrustOptions& options,
                                 const StageContext& context);

}  // namespace stream_recon
