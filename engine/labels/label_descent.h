// Labels on their way down: from the one part that is the whole to the windows.
//
// Guarantees: a node's label is that of the border node it hangs on, turned by the sign; nodes that
// hang on nothing, or on such a node, are unattached. Thread rule: one thread. Memory, reserved: 2
// bits a node of a joined part, two label files, a cursor. Scratch: files of attachments go as they
// have been read.
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "engine/labels/evidence_part.h"
#include "engine/labels/label_file.h"
#include "engine/stage_context.h"

namespace stream_recon {

struct ForestLevel {
  std::vector<EvidencePart> parts;
  /// Which parts of the level below each was joined from: where they end. Empty for windows.
  std::vector<std::size_t> ends;
};

/// \param levels the windows first, the whole last \return A table a window
/// \throw IoError, BudgetError, Interrupted
std::unique_ptr<const LabelFile> descend(std::vector<ForestLevel> levels,
                                         const StageContext& context);

}  // namespace stream_recon
