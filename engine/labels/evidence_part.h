// The evidence that consecutive windows together hand on: nodes ascending, edges in the order of
// the forest; of one window in its export, of several in files of their own.
//
// Thread rule: values; a stream belongs to one thread. Memory: evidence_stream_memory() a stream,
// which the caller reserves.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>

#include "engine/labels/evidence_records.h"
#include "engine/scratch_records.h"
#include "engine/windows/export_cursor.h"

namespace stream_recon {

/// Blocks of the files of evidence.
inline constexpr std::size_t kEvidenceBlock = std::size_t{128} << 10;

struct EvidencePart {
  std::uint64_t first_rank = 0;  ///< of the first window, or no more than that: no evidence below
  std::uint64_t end_rank = 0;    ///< no evidence between two parts: the next one's first
  std::uint64_t nodes = 0;
  std::uint64_t edges = 0;
  std::uint64_t chunk = 0;  ///< of a window's export
  std::string name;         ///< of its files; empty: a window's export

  bool is_window() const { return name.empty(); }
  std::string nodes_file() const { return name + "_nodes"; }
  std::string edges_file() const { return name + "_edges"; }
};

/// Where parts are read from; outlives the streams.
struct EvidenceSource {
  const ScratchDirectory& scratch;
  const ExportReader& exports;
};

constexpr std::uint64_t evidence_stream_memory() {
  return export_cursor_memory() > record_cursor_memory(kEvidenceBlock)
             ? export_cursor_memory()
             : record_cursor_memory(kEvidenceBlock);
}

template <class Record>
class EvidenceStream {
 public:
  /// \throw IoError
  EvidenceStream(const EvidenceSource& source, const EvidencePart& part) {
    constexpr bool kIsNodes = std::is_same_v<Record, NodeKey>;
    if (part.is_window()) {
      constexpr auto kKind = kIsNodes ? ExportKind::kEvidenceNodes : ExportKind::kEvidenceEdges;
      window_ = std::make_unique<ExportCursor<Record>>(source.exports, kKind, part.chunk);
    } else {
      file_ = std::make_unique<ScratchReader<Record>>(
          source.scratch, kIsNodes ? part.nodes_file() : part.edges_file());
    }
  }

  /// Fills the front of `out` with the next records; their number, less than asked only at the
  /// end. \throw IoError
  std::size_t read(std::span<Record> out) {
    return window_ ? window_->read(out) : file_->read(out);
  }

 private:
  std::unique_ptr<ExportCursor<Record>> window_;
  std::unique_ptr<ScratchReader<Record>> file_;
};

}  // namespace stream_recon
