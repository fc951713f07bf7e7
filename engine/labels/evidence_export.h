// How the evidence of a window that others must know goes to disk.
//
// Guarantees: the window's border nodes as a table, ascending by key, and the edges between them in
// the order of the forest, both under the window's first rank as chunk (docs/formats.md).
// Thread rule: one thread. Memory: evidence_export_memory().
#pragma once

#include <cstdint>
#include <span>

#include "engine/labels/evidence_records.h"
#include "engine/labels/signed_forest.h"
#include "engine/node_set.h"
#include "engine/windows/export_writer.h"
#include "engine/windows/final_window.h"

namespace stream_recon {

struct WindowBorder {
  PointRank first_rank = 0;       ///< of the window
  const NodeSet& nodes;           ///< numbered
  std::span<const NodeKey> keys;  ///< distinct, of the border nodes in the order of their numbers
};

/// Writes both, and makes attachments and edges of `contraction` name border nodes by their
/// position in the table instead of their number. Labels are asked for by that position later.
/// \throw IoError
void export_evidence(const WindowBorder& border, Contraction& contraction, ExportWriter& out);

/// Bytes, beside what is handed over.
constexpr std::uint64_t evidence_export_memory(std::uint64_t border_nodes) {
  return border_nodes * (sizeof(std::uint64_t) + sizeof(std::uint32_t));
}

}  // namespace stream_recon
