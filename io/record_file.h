// Block files (io/block_file.h) of one type of record.
//
// Guarantees and costs as there. A record is trivially copyable, without padding (its bytes go to
// disk as they are in memory, little endian), and laid out in docs/formats.md.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>
#include <utility>

#include "io/block_file.h"

namespace stream_recon {

template <class Record>
concept DiskRecord = std::is_trivially_copyable_v<Record> && !std::is_pointer_v<Record>;

template <DiskRecord Record>
class RecordWriter {
 public:
  explicit RecordWriter(File file, std::size_t block_bytes = std::size_t{1} << 20,
                        const BlockBatch& batch = {})
      : writer_(std::move(file), {sizeof(Record), block_bytes, batch}) {}

  void append(std::span<const Record> records) { writer_.append(std::as_bytes(records)); }
  void append(const Record& record) { append(std::span(&record, 1)); }
  void finish() { writer_.finish(); }

  std::uint64_t record_count() const { return writer_.record_count(); }
  std::size_t memory_bytes() const { return writer_.memory_bytes(); }

 private:
  BlockFileWriter writer_;
};

/// The file itself: a BlockFile known to hold `Record`s.
template <DiskRecord Record>
class RecordFile : public BlockFile {
 public:
  explicit RecordFile(File file) : BlockFile(std::move(file), sizeof(Record)) {}
};

template <DiskRecord Record>
class RecordCursor {
 public:
  explicit RecordCursor(const RecordFile<Record>& file) : cursor_(file) {}

  void seek(std::uint64_t record) { cursor_.seek(record); }
  /// Fills the front of `out`; the number of records, less than asked only at the end.
  std::size_t read(std::span<Record> out) {
    return cursor_.read(std::as_writable_bytes(out)) / sizeof(Record);
  }
  std::uint64_t position() const { return cursor_.position(); }
  std::size_t memory_bytes() const { return cursor_.memory_bytes(); }

 private:
  BlockCursor cursor_;
};

}  // namespace stream_recon
