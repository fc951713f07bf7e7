// All records of a file in the scratch directory, from first to last.
//
// Guarantees: stops between batches where the run is to stop. Thread rule: as its caller. Memory: a
// reader and 128 KiB. Cost: one pass over the file.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "engine/scratch_records.h"
#include "engine/stage_context.h"

namespace stream_recon {

/// Calls take(span) for some at a time, in order. \throw IoError, Interrupted
template <DiskRecord Record, class Take>
void for_each_batch(const StageContext& context, const std::string& name, const Take& take) {
  constexpr std::size_t kBatch = (std::size_t{128} << 10) / sizeof(Record);
  ScratchReader<Record> reader(context.scratch, name);
  std::vector<Record> batch(kBatch);
  while (const std::size_t count = reader.read(batch)) {
    context.stop.check();
    take(std::span<const Record>(batch).first(count));
  }
}

/// The same, for one after the other.
template <DiskRecord Record, class Take>
void for_each_record(const StageContext& context, const std::string& name, const Take& take) {
  for_each_batch<Record>(context, name, [&take](std::span<const Record> some) {
    for (const Record& record : some) take(record);
  });
}

}  // namespace stream_recon
