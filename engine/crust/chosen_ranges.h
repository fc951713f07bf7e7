// Where the lowest samples of the chosen poles lie: what windows must own to own those poles.
//
// Guarantees: ascending, apart; each begins at a leaf of the index. Samples between two that lie
// near each other are in, since a window of its own costs more than they do. Thread rule: one
// caller. Memory, from the budget: a bit a leaf of the index, 16 bytes a range, and a reader. Cost:
// one pass over the pole store.
#pragma once

#include <vector>

#include "engine/power/sample_choice.h"
#include "engine/stage_context.h"
#include "engine/windows/cloud_index.h"
#include "engine/windows/owned_range.h"

namespace stream_recon {

/// Of the poles inside the body that touch a sample of the choice. \pre The pole store is in the
/// scratch directory. \throw IoError, BudgetError, Interrupted
std::vector<OwnedRange> chosen_ranges(const SampleChoice& choice, const CloudIndex& index,
                                      const StageContext& context);

}  // namespace stream_recon
