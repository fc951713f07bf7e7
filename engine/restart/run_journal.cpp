#include "engine/restart/run_journal.h"

namespace stream_recon {

RunJournal::RunJournal(ScratchDirectory& scratch, Manifest manifest, StopRequest& stop)
    : scratch_(scratch), manifest_(std::move(manifest)), stop_(stop) {
  write();
}

void RunJournal::note_windows(const WindowProgress& windows) {
  manifest_.windows = windows;
  write();
}

void RunJournal::close() {
  is_resumable_ = false;
  stop_.set_resumable(false);
  scratch_.discard();
  scratch_.remove(
      kManifest);  // first, so that what a kill leaves of the rest is not taken for more
}

void RunJournal::write() {
  scratch_.replace(kManifest, to_text(manifest_));
  if (!manifest_.order) return;
  is_resumable_ = true;
  scratch_.keep();
  stop_.set_resumable(true);
}

}  // namespace stream_recon
