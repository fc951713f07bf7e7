// What makes two runs the same run: everything that the bytes of the outputs depend on.
//
// Guarantees: memory, threads, scratch, progress and report are no part of it. An input file counts
// with its name, size, time of change and a checksum of parts of it; a pipe with its name.
// Thread rule: pure functions. Cost: 192 KiB read of each input file.
#pragma once

#include <optional>
#include <string>

#include "engine/reconstruct.h"
#include "engine/restart/manifest.h"

namespace stream_recon {

/// \throw IoError an input file cannot be read
RunIdentity identity_of(const RunOptions& options);

/// Whether the run has an output with a name: two such runs must not write the same at once.
bool writes_files(const RunIdentity& identity);

/// Whether both write the same outputs; a run that writes to no file is known by its inputs.
bool have_same_outputs(const RunIdentity& a, const RunIdentity& b);

/// The first thing in which they differ, for a person: "--chunk-points: 100, then 50"; nothing if
/// they are the same run.
std::optional<std::string> difference(const RunIdentity& before, const RunIdentity& now);

}  // namespace stream_recon
