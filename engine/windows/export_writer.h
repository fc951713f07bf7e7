// Writes what one window hands on.
//
// Guarantees: the file has its name once finish() returns, complete; before, another. A window that
// hands on nothing leaves no file. Thread rule: one thread. Memory: memory().
#pragma once

#include <cstdint>
#include <cstring>
#include <map>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "engine/scratch_records.h"
#include "engine/windows/export_layout.h"

namespace stream_recon {

class ExportWriter {
 public:
  /// \param first_rank of the window
  ExportWriter(ScratchDirectory& scratch, std::uint64_t first_rank,
               std::string_view prefix = kExportPrefix)
      : scratch_(scratch), name_(export_name(first_rank, prefix)) {}
  ~ExportWriter();
  ExportWriter(const ExportWriter&) = delete;
  ExportWriter& operator=(const ExportWriter&) = delete;

  static constexpr std::uint64_t memory() {
    return record_file_memory(kExportBlock) + (kMostPending + kPartRecords) * sizeof(ExportRecord);
  }

  /// \throw IoError
  template <ExportableRecord Record>
  void add(ExportKind kind, std::uint64_t chunk, const Record& record) {
    Pending& pending = pending_of(kind, chunk);
    std::memcpy(pending.records.emplace_back().data(), &record, sizeof record);
    if (++pending_count_ >= kMostPending) {
      flush_all();
    } else if (pending.records.size() == kPartRecords) {
      flush(pending);
    }
  }

  /// The number of records. \throw IoError
  std::uint64_t finish();

 private:
  static constexpr std::size_t kPartRecords = kExportBlock / sizeof(ExportRecord);
  static constexpr std::size_t kMostPending = 8 * kPartRecords;

  /// Records that have not been written yet.
  struct Pending {
    ExportKind kind;
    std::uint64_t chunk;
    std::vector<ExportRecord> records;
  };

  Pending& pending_of(ExportKind kind, std::uint64_t chunk) {
    Pending*& last = last_[static_cast<std::size_t>(kind)];
    if (last == nullptr || last->chunk != chunk) last = &find_pending(kind, chunk);
    return *last;
  }
  Pending& find_pending(ExportKind kind, std::uint64_t chunk);
  void flush(Pending& pending);
  void flush_all();

  ScratchDirectory& scratch_;
  std::string name_;
  std::optional<RecordWriter<ExportRecord>> writer_;
  std::map<std::pair<ExportKind, std::uint64_t>, Pending> pending_;
  std::array<Pending*, kExportKinds> last_{};  ///< looked at last, of each kind
  std::size_t pending_count_ = 0;
  std::vector<ExportPart> parts_;
  std::uint64_t records_ = 0;
};

}  // namespace stream_recon
