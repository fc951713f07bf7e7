// The flow of a run: each stage reads what the one before left on disk.
//
// Thread rule: one caller. Memory: the budget of the context.
#pragma once

#include "engine/reconstruct.h"
#include "engine/restart/run_journal.h"
#include "engine/stage_context.h"

namespace stream_recon {

/// Fills in what the stages find out: input, delaunay, surface, windows, stages. What the journal
/// has is not done again.
/// \throw as reconstruct()
void run_pipeline(const RunOptions& options, const StageContext& context, RunJournal& journal,
                  Report& report);

}  // namespace stream_recon
