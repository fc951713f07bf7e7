// Sorts any number of records in the memory it is given: sorted runs on disk, merged on the way
// out.
//
// Guarantees: for_each() delivers all records that were added, in order; records that fit the
// memory never touch the disk. The order is the record's own, so equal records are the same bytes
// and the stream depends on the records alone, not on memory or threads. Thread rule: one thread;
// sorts and packs on all threads of the run. Memory: memory_bytes, reserved as long as records are
// kept; no less than least_memory(). Source: Knuth, The Art of Computer Programming 3,
// section 5.4.1.
#pragma once

#include <algorithm>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "engine/order/run_merger.h"
#include "engine/parallel.h"
#include "engine/parallel_records.h"
#include "engine/stage_context.h"

namespace stream_recon {

struct ExternalSortOptions {
  std::string name;                ///< what its files and its memory are called
  std::uint64_t memory_bytes = 0;  ///< at least ExternalSort::least_memory()
};

template <DiskRecord Record>
class ExternalSort {
 public:
  /// \throw BudgetError
  ExternalSort(const StageContext& context, const ExternalSortOptions& options)
      : context_(context),
        name_(options.name),
        memory_(context.budget.reserve(options.memory_bytes, "sorting the " + name_)),
        blocks_(std::clamp<std::uint64_t>(options.memory_bytes / 4 / record_file_memory(kRunBlock),
                                          1, threads_in_use())) {
    const std::uint64_t packing = blocks_ * record_file_memory(kRunBlock);
    most_ = (options.memory_bytes - std::min(options.memory_bytes, packing)) / sizeof(Record);
    most_ = std::max<std::uint64_t>(most_, kRunBlock / sizeof(Record));
  }

  /// \throw IoError, BudgetError, Interrupted
  void add(const Record& record) {
    if (buffer_.capacity() == 0) buffer_.reserve(most_);
    if (buffer_.size() == most_) spill();
    buffer_.push_back(record);
    ++count_;
  }

  /// Hands all records over, once, in order, and forgets them. \throw as add()
  template <class Take>
  void for_each(const Take& take) {
    if (runs_.empty()) {
      sort_buffer();
      for (const Record& record : buffer_) take(record);
    } else {
      if (!buffer_.empty()) spill();
      std::vector<Record>().swap(buffer_);
      while (runs_.size() > fan_in()) merge_first_runs();
      merge(runs_, take);
    }
    std::vector<Record>().swap(buffer_);
    memory_.resize(0);
  }

  std::uint64_t count() const { return count_; }

  /// Three runs at a time, and one that is written.
  static constexpr std::uint64_t least_memory() {
    return 3 * kReaderMemory + record_file_memory(kRunBlock);
  }

 private:
  static constexpr std::uint64_t kBatch = 1 << 13;
  static constexpr std::uint64_t kReaderMemory = record_cursor_memory(kRunBlock) + kRunBlock;

  std::uint64_t fan_in() const {
    const std::uint64_t packing = blocks_ * record_file_memory(kRunBlock);
    const std::uint64_t left = memory_.bytes() - std::min(memory_.bytes(), packing);
    return std::max<std::uint64_t>(2, left / kReaderMemory);
  }

  void sort_buffer() {
    context_.stop.check();
    parallel_sort(buffer_.begin(), buffer_.end(), std::less<>());
    context_.stop.check();
  }

  void spill() {
    sort_buffer();
    auto writer = create_run();
    writer.append(std::span<const Record>(buffer_));
    writer.finish();
    buffer_.clear();
  }

  RecordWriter<Record> create_run() {
    runs_.push_back(name_ + "_run_" + std::to_string(names_++));
    return create_records<Record>(context_.scratch, runs_.back(), kRunBlock, blocks_);
  }

  void merge_first_runs() {
    const auto cut = runs_.begin() + static_cast<std::ptrdiff_t>(fan_in());
    const std::vector<std::string> group(runs_.begin(), cut);
    runs_.erase(runs_.begin(), cut);
    auto writer = create_run();
    merge(group, [&writer](const Record& record) { writer.append(record); });
    writer.finish();
  }

  template <class Take>
  void merge(const std::vector<std::string>& runs, const Take& take) {
    {
      RunMerger<Record> merger(context_.scratch, runs);
      Record record;
      for (std::uint64_t done = 0; merger.next(record); ++done) {
        if (done % kBatch == 0) context_.stop.check();
        take(record);
      }
    }
    for (const std::string& run : runs) context_.scratch.remove(run);
  }

  const StageContext& context_;
  std::string name_;
  Reservation memory_;
  std::uint64_t blocks_;  ///< of a run, packed side by side
  std::uint64_t most_ = 0;
  std::vector<Record> buffer_;
  std::vector<std::string> runs_;
  std::uint64_t names_ = 0;
  std::uint64_t count_ = 0;
};

}  // namespace stream_recon
