// Notes on disk what a run has finished, as it finishes it.
//
// Guarantees: the manifest in the scratch directory is complete at every moment, also when the
// process is killed, and names nothing that is not there. Once the points are ordered the scratch
// directory is kept until close(); before, only a kill leaves it. Nothing is forced to the device:
// after a power cut what is missing is noticed (restart/open_run.h) and done again. Thread rule:
// one thread at a time. Memory: the manifest. Cost: one small file a call.
#pragma once

#include <optional>
#include <utility>

#include "engine/interrupt.h"
#include "engine/restart/manifest.h"
#include "io/scratch_directory.h"

namespace stream_recon {

/// Name of the manifest in the scratch directory.
inline constexpr const char* kManifest = "manifest";

class RunJournal {
 public:
  /// Writes the manifest. \pre What it names is in `scratch`. \throw IoError
  RunJournal(ScratchDirectory& scratch, Manifest manifest, StopRequest& stop);

  /// What the manifest has of an artefact, or else what `make` returns, which is noted.
  /// \throw IoError
  template <class Artefact, class Make>
  Artefact once(std::optional<Artefact> Manifest::*artefact, const Make& make) {
    if (!(manifest_.*artefact)) {
      manifest_.*artefact = make();
      write();
    }
    return *(manifest_.*artefact);
  }

  const WindowProgress& windows() const { return manifest_.windows; }
  /// \throw IoError
  void note_windows(const WindowProgress& windows);

  /// Whether the scratch directory is kept for a later run to go on from here.
  bool is_resumable() const { return is_resumable_; }
  /// Nothing is left to be resumed: the scratch directory goes with its object.
  void close();

 private:
  void write();

  ScratchDirectory& scratch_;
  Manifest manifest_;
  StopRequest& stop_;
  bool is_resumable_ = false;
};

}  // namespace stream_recon
