// Records sorted into chunks as they come, in one file; read back chunk by chunk.
//
// Guarantees: records(c) has every record appended to chunk c, in the order of appending; a damaged
// file is noticed. Each chunk fills blocks of its own, the last one padded.
// Thread rule: one thread until finish(); then const calls may run side by side.
// Memory, from the budget: spool_memory() until finish(); then 16 bytes a block, and for a call
// that reads spool_reading_memory().
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "engine/budget.h"
#include "engine/chunks/chunk_records.h"
#include "engine/scratch_records.h"
#include "io/scratch_directory.h"

namespace stream_recon {

inline constexpr std::uint64_t kMostPending = std::uint64_t{4} << 20;

struct SpoolOptions {
  ScratchDirectory* scratch = nullptr;
  MemoryBudget* budget = nullptr;
  /// What waits in memory for its block, bytes; less where few records are expected.
  std::uint64_t pending_bytes = kMostPending;
};

namespace detail {

inline constexpr std::uint64_t kSmallestBlock = std::uint64_t{4} << 10;
inline constexpr std::uint64_t kLargestBlock = std::uint64_t{128} << 10;

/// Blocks small enough that one for each chunk can wait in memory.
constexpr std::uint64_t spool_block_bytes(std::uint64_t chunks, std::uint64_t pending) {
  return std::clamp(pending / std::max<std::uint64_t>(chunks, 1), kSmallestBlock, kLargestBlock);
}

}  // namespace detail

/// What a spool holds while it is written, bytes.
constexpr std::uint64_t spool_memory(std::uint64_t chunks, std::uint64_t pending = kMostPending) {
  const std::uint64_t block = detail::spool_block_bytes(chunks, pending);
  return chunks * (block + 64) + record_file_memory(block);
}

/// What a call that reads holds beside its result, bytes.
constexpr std::uint64_t spool_reading_memory(std::uint64_t chunks,
                                             std::uint64_t pending = kMostPending) {
  const std::uint64_t block = detail::spool_block_bytes(chunks, pending);
  return record_cursor_memory(block) + block;
}

template <class Record>
class ChunkSpool {
 public:
  /// \throw IoError, BudgetError
  ChunkSpool(std::string name, std::uint64_t chunk_count, const SpoolOptions& options)
      : name_(std::move(name)),
        scratch_(options.scratch),
        budget_(options.budget),
        pending_bytes_(options.pending_bytes),
        memory_(options.budget->reserve(spool_memory(chunk_count, pending_bytes_),
                                        "the chunks of " + name_)),
        records_per_block_(detail::spool_block_bytes(chunk_count, pending_bytes_) / sizeof(Record)),
        chunks_(chunk_count),
        writer_(create_records<Record>(*scratch_, name_, records_per_block_ * sizeof(Record))) {}
  ~ChunkSpool() = default;
  ChunkSpool(const ChunkSpool&) = delete;
  ChunkSpool& operator=(const ChunkSpool&) = delete;

  /// \throw IoError
  void append(std::uint64_t chunk, const Record& record) {
    Chunk& target = chunks_[chunk];
    target.pending.push_back(record);
    ++target.count;
    if (target.pending.size() == records_per_block_) flush(target);
  }

  /// No more records; memory is given back. \throw IoError
  void finish() {
    for (Chunk& chunk : chunks_) {
      if (chunk.pending.empty()) continue;
      chunk.pending.resize(records_per_block_);
      flush(chunk);
      chunk.pending = {};
    }
    writer_->finish();
    writer_.reset();
    // The blocks of each chunk here, and where they lie in the file.
    memory_.resize(chunks_.size() * sizeof(Chunk) + 16 * blocks_);
    file_.emplace(scratch_->open(name_));
  }

  std::uint64_t count(std::uint64_t chunk) const { return chunks_[chunk].count; }

  /// Calls visit(span) for the records of a chunk, a block at a time. \pre finish()
  /// \throw IoError, BudgetError
  template <class Visit>
  void visit(std::uint64_t chunk, const Visit& visit) const {
    const Chunk& source = chunks_[chunk];
    if (source.count == 0) return;
    const Reservation memory = budget_->reserve(
        spool_reading_memory(chunks_.size(), pending_bytes_), "reading the chunks of " + name_);
    RecordCursor<Record> cursor(*file_);
    std::vector<Record> records(records_per_block_);
    std::uint64_t rest = source.count;
    for (const std::uint64_t block : source.blocks) {
      const auto part = std::span(records).first(std::min<std::uint64_t>(records.size(), rest));
      cursor.seek(block * records_per_block_);
      cursor.read(part);
      visit(std::span<const Record>(part));
      rest -= part.size();
    }
  }

  /// The caller reserves count() records. \pre finish() \throw IoError, BudgetError
  std::vector<Record> records(std::uint64_t chunk) const {
    return gather_records<Record>(*this, chunk);
  }

 private:
  struct Chunk {
    std::vector<Record> pending;
    std::vector<std::uint64_t> blocks;
    std::uint64_t count = 0;
  };

  void flush(Chunk& chunk) {
    chunk.blocks.push_back(blocks_++);
    writer_->append(std::span<const Record>(chunk.pending));
    chunk.pending.clear();
  }

  std::string name_;
  ScratchDirectory* scratch_;
  MemoryBudget* budget_;
  std::uint64_t pending_bytes_;
  Reservation memory_;
  std::size_t records_per_block_;
  std::vector<Chunk> chunks_;
  std::uint64_t blocks_ = 0;
  std::optional<RecordWriter<Record>> writer_;
  std::optional<RecordFile<Record>> file_;
};

}  // namespace stream_recon
