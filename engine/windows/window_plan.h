// How the windows share the memory out.
//
// Guarantees: what the plan takes fits what the budget has left; windows are of about one size, as
// many for every thread. Thread rule: a pure function.
#pragma once

#include <cstdint>

#include "engine/budget.h"
#include "engine/windows/cloud_index.h"

namespace stream_recon {

struct WindowStageOptions {
  unsigned threads = 1;
  /// Owned points of a window at most; 0: as many as the memory allows.
  std::uint64_t window_points = 0;
  /// What the consumers need for each owned point while a window is theirs, bytes.
  std::uint64_t consumer_bytes_a_point = 0;
  bool whole_stars = false;  ///< see CertifiedWindowOptions
};

struct WindowPlan {
  unsigned threads = 1;  ///< fewer than asked where windows would become too small
  std::uint64_t cache_bytes = 0;
  std::uint64_t fixed_bytes = 0;   ///< each thread's, besides its window
  std::uint64_t window_bytes = 0;  ///< each, its consumers included
  std::uint64_t build_bytes = 0;   ///< of these, until the consumers come
  std::uint64_t window_points = 0;
  bool whole_stars = false;
  std::uint64_t step = 1;  ///< what a window owns is a multiple of this
};

/// \throw BudgetError the least window does not fit
WindowPlan plan_windows(const CloudIndex& index, const WindowStageOptions& options,
                        const MemoryBudget& budget);

}  // namespace stream_recon
