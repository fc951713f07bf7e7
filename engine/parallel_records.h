// Record files written and read on all threads.
//
// Guarantees: as io/record_file.h; the bytes are those of a writer with one thread. Thread rule:
// one caller. Memory: record_file_memory() a block of a batch, record_cursor_memory() a reader.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>

#include "engine/budget.h"
#include "engine/parallel.h"
#include "engine/scratch_records.h"

namespace stream_recon {

/// Blocks that a writer encodes together: no more than are of use, nor than an eighth of the memory
/// holds.
inline std::size_t blocks_at_once(std::uint64_t block_bytes, const MemoryBudget& budget) {
  // Small blocks are soon done, and a loop takes a while to begin.
  const std::uint64_t blocks_a_thread = block_bytes > (std::uint64_t{64} << 10) ? 1 : 4;
  return std::clamp<std::uint64_t>(budget.available() / 8 / record_file_memory(block_bytes), 1,
                                   blocks_a_thread * threads_in_use());
}

/// The caller reserves the memory of `blocks` blocks. \throw IoError cannot create
template <DiskRecord Record>
RecordWriter<Record> create_records(ScratchDirectory& scratch, const std::string& name,
                                    std::size_t block_bytes, std::size_t blocks) {
  const auto loop = [](std::size_t count, const std::function<void(std::size_t)>& body) {
    parallel_for_ranges(count, 1, [&body](std::size_t begin, std::size_t end) {
      for (; begin < end; ++begin) body(begin);
    });
  };
  return RecordWriter<Record>(scratch.create(name), block_bytes, {blocks, loop});
}

}  // namespace stream_recon
