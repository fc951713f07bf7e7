// All windows of a cloud: cut by the memory there is, built side by side, handed to the consumers.
//
// Guarantees: every rank is owned by one window, so that the consumers see each simplex of the
// cloud once, whatever the memory and the threads. What is told as finished is in the scratch
// directory for good: a later run goes on from there. A window that outgrows its memory is split
// and built again; only when sixteen points' stars do not fit is the budget impossible. Thread
// rule: called by one thread; consumers are called by many at once. Memory: all that the budget has
// left, or less if the cloud needs less.
#pragma once

#include <cstdint>
#include <functional>
#include <span>

#include "engine/stage_context.h"
#include "engine/windows/window_plan.h"
#include "engine/windows/window_progress.h"

namespace stream_recon {

/// Who wants to know that windows are finished; called by one thread at a time.
using WindowObserver = std::function<void(const WindowProgress&)>;

struct WindowStageParts {
  const CloudIndex& index;
  std::span<WindowConsumer* const> consumers;
  WindowObserver observer;  ///< may be empty
};

/// Builds the windows that `progress` lacks. \return The whole progress
/// \throw BudgetError, IoError, Interrupted
WindowProgress run_window_stage(const WindowStageParts& parts, WindowProgress progress,
                                const WindowStageOptions& options, const StageContext& context);

}  // namespace stream_recon
