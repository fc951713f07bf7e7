// What is wrong with the options of a run, before any work is done.
//
// Thread rule: pure functions.
#pragma once

#include "engine/reconstruct.h"

namespace stream_recon {

/// \throw std::invalid_argument one line: what, and what to do
void check_options(const RunOptions& options);

}  // namespace stream_recon
