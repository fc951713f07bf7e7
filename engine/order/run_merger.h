// Merges sorted runs on disk into one sorted stream.
//
// Guarantees: next() delivers the records of all runs in order. Thread rule: one thread.
// Memory: RunMerger::memory(runs). Source: Knuth, The Art of Computer Programming 3, section 5.4.1.
#pragma once

#include <algorithm>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

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
      : runs_(runs.size()) {
    for (std::size_t i = 0; i < runs.size(); ++i) {
      runs_[i].reader = std::make_unique<ScratchReader<Record>>(scratch, runs[i]);
      if (runs_[i].refill()) push(i);
    }
  }

  /// False at the end. \throw IoError
  bool next(Record& record) {
    if (heap_.empty()) return false;
    std::pop_heap(heap_.begin(), heap_.end(), Later{&runs_});
    const std::size_t winner = heap_.back();
    heap_.pop_back();
    Run& run = runs_[winner];
    record = run.front();
    ++run.next;
    if (run.next < run.buffer.size() || run.refill()) push(winner);
    return true;
  }

  /// Bytes for merging `runs` runs.
  static constexpr std::uint64_t memory(std::uint64_t runs) {
    return runs * (record_file_memory(kRunBlock) + kRunBlock);
  }

 private:
  struct Run {
    std::unique_ptr<ScratchReader<Record>> reader;
    std::vector<Record> buffer;
    std::size_t next = 0;

    bool refill() {
      buffer.resize(kRunBlock / sizeof(Record));
      buffer.resize(reader->read(buffer));
      next = 0;
      return !buffer.empty();
    }
    const Record& front() const { return buffer[next]; }
  };

  struct Later {
    const std::vector<Run>* runs;
    bool operator()(std::size_t a, std::size_t b) const {
      return (*runs)[b].front() < (*runs)[a].front();
    }
  };

  void push(std::size_t run) {
    heap_.push_back(run);
    std::push_heap(heap_.begin(), heap_.end(), Later{&runs_});
  }

  std::vector<Run> runs_;
  std::vector<std::size_t> heap_;  ///< runs that are not empty, the one with the least front first
};

}  // namespace stream_recon
