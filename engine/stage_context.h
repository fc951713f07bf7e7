// Where a stage gets its resources.
//
// Thread rule: the parts' own.
#pragma once

#include "engine/budget.h"
#include "engine/interrupt.h"
#include "engine/progress.h"
#include "io/scratch_directory.h"

namespace stream_recon {

/// All parts outlive the stage.
struct StageContext {
  ScratchDirectory& scratch;
  MemoryBudget& budget;
  Progress& progress;
  const StopRequest& stop;
};

}  // namespace stream_recon
