// Files of equal records in compressed, checked blocks: spools, sorted runs, the point store.
//
// Guarantees: records come back bit for bit, in sequence or at random. A file cut short, extended
// or changed in any byte is noticed: on opening, or on reading the block concerned; the IoError
// names block and byte. A file whose writer did not finish() cannot be opened.
// Memory: stated at each class. Format: docs/formats.md.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "io/block_codec.h"
#include "io/file.h"

namespace stream_recon {

/// Runs body(0) ... body(count - 1), side by side if it can, and waits for them.
using BlockLoop =
    std::function<void(std::size_t count, const std::function<void(std::size_t)>& body)>;

/// How many blocks a writer gathers, to encode them together by `loop`.
struct BlockBatch {
  std::size_t blocks = 1;
  BlockLoop loop = [](std::size_t count, const auto& body) {
    for (std::size_t i = 0; i < count; ++i) body(i);
  };
};

struct BlockFileOptions {
  /// Bytes of one record, 1 to block_bytes.
  std::size_t record_bytes = 0;
  /// Raw bytes of a block, at most 1 GiB; rounded down to whole records.
  std::size_t block_bytes = std::size_t{1} << 20;
  BlockBatch batch = {};
};

/// Appends records; the bytes are the same whatever the batch. Memory: a block and a BlockCodec for
/// each block of the batch, 8 bytes a block written. Thread rule: one.
class BlockFileWriter {
 public:
  /// Writes to `file`, new and empty. \throw IoError; std::invalid_argument sizes out of range
  BlockFileWriter(File file, const BlockFileOptions& options);
  ~BlockFileWriter();
  BlockFileWriter(BlockFileWriter&&) noexcept;
  BlockFileWriter& operator=(BlockFileWriter&&) noexcept;

  /// Appends whole records. \throw IoError
  void append(std::span<const std::byte> records);
  /// Writes the rest and the index, and closes the file. \throw IoError
  void finish();

  std::uint64_t record_count() const { return record_count_; }
  std::size_t memory_bytes() const;

 private:
  struct Block;

  void encode(Block& block, std::uint64_t number) const;
  void write_batch();

  File file_;
  std::size_t record_bytes_;
  std::size_t block_bytes_;
  BlockLoop loop_;
  std::vector<Block> batch_;
  std::size_t filling_ = 0;  ///< block of the batch; those before are full
  std::vector<std::uint64_t> offsets_;
  std::uint64_t record_count_ = 0;
};

/// A finished file. Memory: 8 bytes a block. Thread rule: reading is const and thread-safe, with a
/// codec for each thread.
class BlockFile {
 public:
  /// Checks header and index. \throw IoError damaged, or records of another size
  BlockFile(File file, std::size_t record_bytes);

  std::uint64_t record_count() const { return record_count_; }
  std::uint64_t block_count() const { return offsets_.size() - 1; }
  /// Records of every block but the last: record r is in block r / records_per_block().
  std::size_t records_per_block() const { return records_per_block_; }
  std::size_t record_bytes() const { return record_bytes_; }
  std::size_t records_in_block(std::uint64_t block) const;

  /// Fills the front of `out` with the records of a block; their number. `stored` is a buffer to
  /// be reused, at most one block. \throw IoError the block is damaged
  std::size_t read_block(std::uint64_t block, BlockCodec& codec, std::vector<std::byte>& stored,
                         std::span<std::byte> out) const;

 private:
  [[noreturn]] void fail(const std::string& what, std::uint64_t byte) const;

  File file_;
  std::size_t record_bytes_;
  std::size_t records_per_block_ = 0;
  std::uint64_t record_count_ = 0;
  std::vector<std::uint64_t> offsets_;  ///< of each block, then of the index
};

/// Reads one file block by block, at random or in sequence. Memory: 2 blocks + a BlockCodec.
/// Thread rule: one thread; many cursors may share a file, which must outlive them.
class BlockCursor {
 public:
  explicit BlockCursor(const BlockFile& file);

  /// The next read() begins at this record.
  void seek(std::uint64_t record) { next_ = record; }
  /// Fills the front of `out` with the next records, whole ones; the bytes filled, less than asked
  /// only at the end. \throw IoError
  std::size_t read(std::span<std::byte> out);
  /// The records of a block, valid until the next call. \throw IoError
  std::span<const std::byte> block(std::uint64_t number);

  std::uint64_t position() const { return next_; }
  std::size_t memory_bytes() const;

 private:
  const BlockFile* file_;
  BlockCodec codec_;
  std::vector<std::byte> stored_;
  std::vector<std::byte> records_;
  std::size_t loaded_bytes_ = 0;
  std::uint64_t loaded_;
  std::uint64_t next_ = 0;
};

}  // namespace stream_recon
