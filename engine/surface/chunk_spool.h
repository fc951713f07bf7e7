// Records sorted into chunks as they come, in one file; read back chunk by chunk.
//
// Guarantees: records(c) has every record appended to chunk c, in the order of appending; a damaged
// file is noticed. Each chunk fills blocks of its own, the last one padded.
// Thread rule: one thread. Memory: spool_memory(), taken from the budget when it is made.
#pragma once

#include <algorithm>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "engine/budget.h"
#include "engine/scratch_records.h"
#include "io/scratch_directory.h"

namespace stream_recon {

struct SpoolOptions {
  ScratchDirectory* scratch = nullptr;
  MemoryBudget* budget = nullptr;
};

namespace detail {

inline constexpr std::uint64_t kMostPending = std::uint64_t{4} << 20;
inline constexpr std::uint64_t kSmallestBlock = std::uint64_t{4} << 10;
inline constexpr std::uint64_t kLargestBlock = std::uint64_t{128} << 10;

/// Blocks small enough that one for each chunk can wait in memory.
constexpr std::uint64_t spool_block_bytes(std::uint64_t chunks) {
  return std::clamp(kMostPending / std::max<std::uint64_t>(chunks, 1), kSmallestBlock,
                    kLargestBlock);
}

}  // namespace detail

/// What a spool holds while it is written, bytes.
constexpr std::uint64_t spool_memory(std::uint64_t chunks) {
  const std::uint64_t block = detail::spool_block_bytes(chunks);
  return chunks * (block + 64) + record_file_memory(block);
}

template <class Record>
class ChunkSpool {
 public:
  /// \throw IoError, BudgetError
  ChunkSpool(std::string name, std::uint64_t chunk_count, const SpoolOptions& options)
      : name_(std::move(name)),
        scratch_(options.scratch),
        memory_(options.budget->reserve(spool_memory(chunk_count), "the chunks of " + name_)),
        records_per_block_(detail::spool_block_bytes(chunk_count) / sizeof(Record)),
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

  /// No more records; the memory is given back but for a reader's. \throw IoError
  void finish() {
    for (Chunk& chunk : chunks_) {
      if (chunk.pending.empty()) continue;
      chunk.pending.resize(records_per_block_);
      flush(chunk);
      chunk.pending = {};
    }
    writer_->finish();
    writer_.reset();
    const std::uint64_t block_bytes = records_per_block_ * sizeof(Record);
    memory_.resize(record_file_memory(block_bytes) + chunks_.size() * sizeof(Chunk) + 8 * blocks_);
    reader_ = std::make_unique<ScratchReader<Record>>(*scratch_, name_);
  }

  std::uint64_t count(std::uint64_t chunk) const { return chunks_[chunk].count; }

  /// Calls visit(span) for the records of a chunk, a block at a time. \pre finish() \throw IoError
  template <class Visit>
  void visit(std::uint64_t chunk, const Visit& visit) const {
    const Chunk& source = chunks_[chunk];
    std::vector<Record> records(records_per_block_);
    std::uint64_t rest = source.count;
    for (const std::uint64_t block : source.blocks) {
      const auto part = std::span(records).first(std::min<std::uint64_t>(records.size(), rest));
      reader_->read_at(block * records_per_block_, part);
      visit(std::span<const Record>(part));
      rest -= part.size();
    }
  }

  /// The caller reserves count() records. \pre finish() \throw IoError
  std::vector<Record> records(std::uint64_t chunk) const {
    std::vector<Record> records;
    records.reserve(count(chunk));
    visit(chunk, [&records](std::span<const Record> part) {
      records.insert(records.end(), part.begin(), part.end());
    });
    return records;
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
  Reservation memory_;
  std::size_t records_per_block_;
  std::vector<Chunk> chunks_;
  std::uint64_t blocks_ = 0;
  std::optional<RecordWriter<Record>> writer_;
  std::unique_ptr<ScratchReader<Record>> reader_;
};

}  // namespace stream_recon
