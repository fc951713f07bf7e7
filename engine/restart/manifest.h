// What a run has finished, as it lies in its scratch directory: what a later run needs to go on.
//
// Guarantees: from_text(to_text(m)) is m; a text that was changed or cut short is noticed.
// Format: docs/formats.md. Thread rule: a value.
#pragma once

#include <map>
#include <optional>
#include <string>

#include "engine/order/hilbert_sort.h"
#include "engine/order/ingest.h"
#include "engine/windows/window_progress.h"

namespace stream_recon {

/// What the bytes of the outputs depend on, by name, as a person would write it.
using RunIdentity = std::map<std::string, std::string>;

struct Manifest {
  RunIdentity identity;
  std::optional<CloudSummary> cloud;  ///< the ingest spool is complete
  std::optional<OrderResult> order;   ///< the point store is complete, the spool gone
  WindowProgress windows;
};

std::string to_text(const Manifest& manifest);
/// Nothing if the text is damaged, or of another version of the program.
std::optional<Manifest> manifest_from_text(const std::string& text);

}  // namespace stream_recon
