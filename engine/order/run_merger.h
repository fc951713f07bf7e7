// Merges sorted runs on disk into one sorted stream.
//
// Guarantees: next() delivers the records of all runs in order. Thread rule: one thread.
// Memory: RunMerger::memory(runs). Source: Knuth, The Art of Computer Programming 3, section 5.4.1.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "engine/order/sort_record.h"
#include "engine/scratch_records.h"
#include "io/scratch_directory.h"

namespace stream_recon {

inline constexpr std::size_t kRunBlock = std::size_t{128} << 10;

class RunMerger {
 public:
  /// \throw IoError
  RunMerger(const ScratchDirectory& scratch, const std::vector<std::string>& runs);

  /// False at the end. \throw IoError
  bool next(SortRecord& record);

  /// Bytes for merging `runs` runs.
  static constexpr std::uint64_t memory(std::uint64_t runs) {
    return runs * (record_file_memory(kRunBlock) + kRunBlock);
  }

 private:
  struct Run {
    std::unique_ptr<ScratchReader<SortRecord>> reader;
    std::vector<SortRecord> buffer;
    std::size_t next = 0;

    bool refill();
    const SortRecord& front() const { return buffer[next]; }
  };

  void push(std::size_t run);

  std::vector<Run> runs_;
  std::vector<std::size_t> heap_;  ///< runs that are not empty, the one with the least front first
};

}  // namespace stream_recon
