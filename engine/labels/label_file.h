// The labels of many tables of nodes, one after the other in one scratch file.
//
// Guarantees: labels come back as they were appended. The file goes with the object, finished or
// not. Thread rule: one thread until finish(), then const access from many.
// Memory, reserved: writing_memory() until finish(); 16 bytes a table; and, by labels(), the labels
// and reading_memory() while they are read.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "engine/labels/node_labels.h"
#include "engine/scratch_records.h"
#include "engine/stage_context.h"

namespace stream_recon {

class LabelFile {
 public:
  /// \param tables that there will be \throw IoError, BudgetError
  LabelFile(std::string name, std::uint64_t tables, const StageContext& context);
  ~LabelFile();
  LabelFile(const LabelFile&) = delete;
  LabelFile& operator=(const LabelFile&) = delete;

  static constexpr std::uint64_t writing_memory() { return record_file_memory(kBlock); }
  static constexpr std::uint64_t reading_memory() { return record_cursor_memory(kBlock); }

  /// Begins the next table.
  void begin_table(std::uint64_t nodes);
  /// Its next node's. \throw IoError
  void append(NodeLabel label);
  /// No more tables. \pre Every table has all its labels \throw IoError
  void finish();

  /// \pre finish() \throw IoError, BudgetError
  NodeLabels labels(std::uint64_t table) const;
  /// Of all tables.
  std::uint64_t unattached() const { return unattached_; }

 private:
  static constexpr std::size_t kBlock = std::size_t{32} << 10;

  struct Table {
    std::uint64_t nodes = 0;
    std::uint64_t first_word = 0;
  };

  ScratchDirectory& scratch_;
  MemoryBudget& budget_;
  std::string name_;
  Reservation memory_;
  std::vector<Table> tables_;
  std::uint64_t appended_ = 0;  ///< labels of the last table
  std::uint64_t unattached_ = 0;
  std::uint64_t word_ = 0;  ///< those that are not written yet
  std::optional<RecordWriter<std::uint64_t>> writer_;
  std::optional<RecordFile<std::uint64_t>> file_;
};

}  // namespace stream_recon
