// What all windows have handed on, by kind and chunk.
//
// Guarantees: visit(kind, chunk) delivers every record that any window added to it, in an order
// that depends on the windows; damage is noticed. Thread rule: const access from many threads.
// Memory, from the budget: 24 bytes for up to 4096 records; read_memory() for each
// thread that reads.
#pragma once

#include <array>
#include <cstdint>
#include <cstring>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "engine/budget.h"
#include "engine/chunks/chunk_records.h"
#include "engine/scratch_records.h"
#include "engine/windows/export_layout.h"

namespace stream_recon {

namespace detail {
class RawExportCursor;
}

/// \throw IoError always: says that an export is not what a window has written
[[noreturn]] void throw_damaged_export(const std::string& name);

class ExportReader {
 public:
  /// Reads the tables of all exports in `scratch`, which must outlive the reader.
  /// \throw IoError, BudgetError
  ExportReader(const ScratchDirectory& scratch, MemoryBudget& budget);

  /// What a thread takes from the budget while it reads, bytes: a reader, a part of the records,
  /// and that part as records of its kind.
  static constexpr std::uint64_t read_memory() {
    return record_file_memory(kExportBlock) + 2 * kExportBlock;
  }

  std::uint64_t files() const { return files_.size(); }
  /// Of all kinds and chunks.
  std::uint64_t records() const { return records_; }
  std::uint64_t count(ExportKind kind, std::uint64_t chunk) const;
  /// Those that have records of the kind, ascending.
  std::vector<std::uint64_t> chunks(ExportKind kind) const;

  /// Calls visit(span) for the records of a chunk, some at a time. \throw IoError, BudgetError
  template <ExportableRecord Record, class Visit>
  void visit(ExportKind kind, std::uint64_t chunk, const Visit& visit) const {
    std::vector<Record> records;
    visit_raw(kind, chunk, [&](std::span<const ExportRecord> part) {
      records.resize(part.size());
      for (std::size_t i = 0; i < part.size(); ++i) {
        std::memcpy(&records[i], part[i].data(), sizeof(Record));
      }
      visit(std::span<const Record>(records));
    });
  }

 private:
  friend class detail::RawExportCursor;

  struct Part {
    std::uint64_t chunk;
    std::uint64_t first;
    std::uint32_t file;
    std::uint32_t count;
  };
  using VisitRaw = std::function<void(std::span<const ExportRecord>)>;

  void read_table(const ScratchDirectory& scratch, const std::string& name);
  std::span<const Part> parts_of(ExportKind kind, std::uint64_t chunk) const;
  void visit_raw(ExportKind kind, std::uint64_t chunk, const VisitRaw& visit) const;

  const ScratchDirectory& scratch_;
  MemoryBudget& budget_;
  Reservation memory_;
  std::vector<std::string> files_;
  std::array<std::vector<Part>, kExportKinds> parts_;  ///< by chunk, file, first
  std::uint64_t records_ = 0;
};

/// The records of one kind.
template <ExportableRecord Record>
class ExportedRecords {
 public:
  ExportedRecords(const ExportReader& reader, ExportKind kind) : reader_(&reader), kind_(kind) {}

  std::uint64_t count(std::uint64_t chunk) const { return reader_->count(kind_, chunk); }

  /// Calls visit(span) for the records of a chunk, some at a time. \throw IoError, BudgetError
  template <class Visit>
  void visit(std::uint64_t chunk, const Visit& visit) const {
    reader_->visit<Record>(kind_, chunk, visit);
  }

  /// The caller reserves count() records. \throw IoError, BudgetError
  std::vector<Record> records(std::uint64_t chunk) const {
    return gather_records<Record>(*this, chunk);
  }

 private:
  const ExportReader* reader_;
  ExportKind kind_;
};

}  // namespace stream_recon
