// All windows of a cloud: cut by the memory there is, built side by side, handed to the consumers.
//
// Guarantees: every rank is owned by one window, so that the consumers see each simplex of the
// cloud once, whatever the memory and the threads. A window that outgrows its memory is split and
// built again; only when sixteen points' stars do not fit is the budget impossible. Thread rule:
// called by one thread; consumers are called by many at once. Memory: all that the budget has left,
// or less if the cloud needs less.
#pragma once

#include <cstdint>
#include <span>

#include "engine/stage_context.h"
#include "engine/windows/certified_window.h"

namespace stream_recon {

struct WindowStageOptions {
  unsigned threads = 1;
  /// Owned points of a window at most; 0: as many as the memory allows.
  std::uint64_t window_points = 0;
};

struct WindowStageResult {
  std::uint64_t windows = 0;
  std::uint64_t splits = 0;
  WindowCounts counts;
};

/// \throw BudgetError, IoError, Interrupted
WindowStageResult run_window_stage(const CloudIndex& index,
                                   std::span<WindowConsumer* const> consumers,
                                   const WindowStageOptions& options, const StageContext& context);

}  // namespace stream_recon
