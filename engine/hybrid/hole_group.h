// Records in the order of their holes, as a stream that is asked for one hole after the other.
//
// Guarantees: holes are asked for in ascending order; those that are not are passed over. Thread
// rule: one thread. Memory: a reader, a batch of records, and what is taken.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "engine/hybrid/hole_records.h"
#include "engine/scratch_records.h"

namespace stream_recon {

template <class Record>
class HoleGroups {
 public:
  /// \throw IoError
  HoleGroups(const ScratchDirectory& scratch, const std::string& name)
      : reader_(scratch, name), batch_(kBatch) {}

  static constexpr std::uint64_t memory() {
    return record_cursor_memory(kHoleBlock) + kBatch * sizeof(Record);
  }

  /// The hole of the next record; nothing at the end. \throw IoError
  std::optional<std::uint32_t> next_hole() {
    if (!fill()) return std::nullopt;
    return batch_[at_].hole;
  }

  /// Calls take(record) for those of this hole. \throw IoError
  template <class Take>
  void visit(std::uint32_t hole, const Take& take) {
    while (fill() && batch_[at_].hole <= hole) {
      if (batch_[at_].hole == hole) take(batch_[at_]);
      ++at_;
    }
  }

 private:
  static constexpr std::size_t kBatch = 1 << 10;

  /// Whether there is a record.
  bool fill() {
    if (at_ == count_) {
      count_ = reader_.read(batch_);
      at_ = 0;
    }
    return at_ < count_;
  }

  ScratchReader<Record> reader_;
  std::vector<Record> batch_;
  std::size_t at_ = 0;
  std::size_t count_ = 0;
};

}  // namespace stream_recon
