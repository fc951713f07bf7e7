// What windows have handed on of one kind and chunk, as a stream that is asked for records.
//
// Guarantees: as ExportReader's, which must outlive it; one window's records come in the order it
// added them in. Thread rule: one thread, others may have cursors of their own.
// Memory: export_cursor_memory(), which the caller reserves.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <memory>
#include <span>
#include <vector>

#include "engine/windows/export_reader.h"

namespace stream_recon {

namespace detail {

class RawExportCursor {
 public:
  RawExportCursor(const ExportReader& reader, ExportKind kind, std::uint64_t chunk)
      : reader_(&reader), parts_(reader.parts_of(kind, chunk)) {}

  /// Fills the front of `out` with the next records; their number, less than asked only at the
  /// end. \throw IoError
  std::size_t read(std::span<ExportRecord> out);

 private:
  const ExportReader* reader_;
  std::span<const ExportReader::Part> parts_;  ///< not read to their ends
  std::uint32_t done_ = 0;                     ///< records of the first of them
  std::uint32_t open_ = 0;                     ///< file
  std::unique_ptr<ScratchReader<ExportRecord>> file_;
};

inline constexpr std::size_t kExportBatch = 512;

}  // namespace detail

constexpr std::uint64_t export_cursor_memory() {
  return record_cursor_memory(kExportBlock) + detail::kExportBatch * sizeof(ExportRecord);
}

template <ExportableRecord Record>
class ExportCursor {
 public:
  ExportCursor(const ExportReader& reader, ExportKind kind, std::uint64_t chunk)
      : cursor_(reader, kind, chunk), batch_(detail::kExportBatch) {}

  /// Fills the front of `out` with the next records; their number, less than asked only at the
  /// end. \throw IoError
  std::size_t read(std::span<Record> out) {
    std::size_t filled = 0;
    while (filled < out.size()) {
      const std::size_t wanted = std::min(out.size() - filled, batch_.size());
      const std::size_t count = cursor_.read(std::span(batch_).first(wanted));
      for (std::size_t i = 0; i < count; ++i) {
        std::memcpy(&out[filled + i], batch_[i].data(), sizeof(Record));
      }
      filled += count;
      if (count < wanted) break;
    }
    return filled;
  }

 private:
  detail::RawExportCursor cursor_;
  std::vector<ExportRecord> batch_;
};

}  // namespace stream_recon
