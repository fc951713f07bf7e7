// Merges sorted runs on disk into one sorted stream.
//
// Guarantees: next() delivers the records of all runs in order. Thread rule: one thread.
// Memory: RunMerger::memory(runs).
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "engine/order/stream_merger.h"
#include "engine/scratch_records.h"
#include "io/scratch_directory.h"

namespace stream_recon {

inline constexpr std::size_t kRunBlock = std::size_t{128} << 10;

/// \tparam Record with a total operator<
template <DiskRecord Record>
class RunMerger {
 public:
  /// \throw IoError
  RunMerger(const ScratchDirectory& scratch, const std::vector<std::string>& runs)
      : merger_(open(scratch, runs), kRunBlock / sizeof(Record)) {}

  /// False at the end. \throw IoError
  bool next(Record& record) { return merger_.next(record).has_value(); }

  /// Bytes for merging `runs` runs.
  static constexpr std::uint64_t memory(std::uint64_t runs) {
    return runs * (record_file_memory(kRunBlock) + kRunBlock);
  }

 private:
  using Readers = std::vector<std::unique_ptr<ScratchReader<Record>>>;

  static Readers open(const ScratchDirectory& scratch, const std::vector<std::string>& runs) {
    Readers readers;
    readers.reserve(runs.size());
    for (const std::string& run : runs) {
      readers.push_back(std::make_unique<ScratchReader<Record>>(scratch, run));
    }
    return readers;
  }

  StreamMerger<Record, ScratchReader<Record>> merger_;
};

}  // namespace stream_recon
