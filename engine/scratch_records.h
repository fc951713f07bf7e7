// Record files (io/record_file.h) in the scratch directory, by name.
//
// Guarantees and thread rule as there. Memory: record_file_memory() for each writer or reader.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

#include "io/record_file.h"
#include "io/scratch_directory.h"

namespace stream_recon {

/// What a writer or a reader of blocks of `block_bytes` holds at most, bytes: the block as it is,
/// transformed and compressed, and zstd's tables.
constexpr std::uint64_t record_file_memory(std::uint64_t block_bytes) {
  return 3 * block_bytes + (std::uint64_t{3} << 19);
}

/// What a cursor on a file of blocks of `block_bytes` holds at most, bytes: no compressor's tables.
constexpr std::uint64_t record_cursor_memory(std::uint64_t block_bytes) {
  return 3 * block_bytes + (std::uint64_t{1} << 18);
}

/// \throw IoError cannot create
template <DiskRecord Record>
RecordWriter<Record> create_records(ScratchDirectory& scratch, const std::string& name,
                                    std::size_t block_bytes) {
  return RecordWriter<Record>(scratch.create(name), block_bytes);
}

template <DiskRecord Record>
class ScratchReader {
 public:
  /// \throw IoError damaged
  ScratchReader(const ScratchDirectory& scratch, const std::string& name)
      : file_(scratch.open(name)), cursor_(file_) {}
  ScratchReader(const ScratchReader&) = delete;
  ScratchReader& operator=(const ScratchReader&) = delete;

  std::uint64_t count() const { return file_.record_count(); }

  /// Fills the front of `out` with the next records; their number, less than asked only at the
  /// end. \throw IoError
  std::size_t read(std::span<Record> out) { return cursor_.read(out); }

  /// The same from a position on; neighbours in one block cost nothing. \throw IoError
  std::size_t read_at(std::uint64_t position, std::span<Record> out) {
    cursor_.seek(position);
    return cursor_.read(out);
  }

 private:
  RecordFile<Record> file_;
  RecordCursor<Record> cursor_;
};

}  // namespace stream_recon
