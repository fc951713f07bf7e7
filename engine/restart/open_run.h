// Where a run begins: in a scratch directory of its own, or in that of a run that was killed.
//
// Guarantees: a run goes on only from a run of the same identity and only from artefacts whose
// every block is intact; the rest is done again. What dead runs of the same output files have left,
// beside the files too, is removed; of runs without such files only what cannot be resumed, since
// it may be another pipe's. Two live runs never write the same files.
// Thread rule: one thread. Memory: a few blocks. Cost: one pass over what is resumed.
#pragma once

#include <memory>

#include "engine/reconstruct.h"
#include "engine/restart/manifest.h"
#include "io/scratch_directory.h"

namespace stream_recon {

struct OpenedRun {
  std::unique_ptr<ScratchDirectory> scratch;
  Manifest manifest;  ///< has the identity of this run; more if it goes on from another
};

/// \throw std::invalid_argument, InputError options or input differ from those of the run to be
/// resumed; IoError, also when another run writes the same outputs
OpenedRun open_run(const RunOptions& options, RunIdentity identity);

}  // namespace stream_recon
