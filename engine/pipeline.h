// The flow of a run: each stage reads what the one before left on disk.
//
// Thread rule: one caller. Memory: the budget of the context.
#pragma once

#include "engine/reconstruct.h"
#include "engine/stage_context.h"

namespace stream_recon {

/// Fills in what the stages find out: input, delaunay, surface, windows, stages.
/// \throw as reconstruct()
void run_pipeline(const RunOptions& options, const StageContext& context, Report& report);

}  // namespace stream_recon
