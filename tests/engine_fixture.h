// What a stage needs to run in a test: scratch, budget, silence.
#pragma once

#include <cstdint>
#include <limits>

#include "engine/stage_context.h"
#include "tests/io_test_folder.h"

namespace stream_recon {

struct StageFixture {
  explicit StageFixture(std::uint64_t memory_bytes = std::numeric_limits<std::uint64_t>::max())
      : scratch({.parent = folder.path()}), budget(memory_bytes) {}

  TestFolder folder;
  ScratchDirectory scratch;
  MemoryBudget budget;
  Progress progress{ProgressStyle::kNone};
  StopRequest stop;
  StageContext context{scratch, budget, progress, stop};
};

}  // namespace stream_recon
