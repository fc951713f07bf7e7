// Chunks side by side: each taken once, in order where asked, whatever fails.

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <mutex>
#include <stdexcept>
#include <utility>
#include <vector>

#include "engine/budget.h"
#include "engine/chunks/chunk_loop.h"

namespace stream_recon {
namespace {

struct Made {
  std::uint64_t chunk;
  Reservation memory;
};

/// The chunks in the order they were taken; each needs as many bytes as its number, while it lives.
std::vector<std::uint64_t> taken(const ChunkLoopOptions& options, MemoryBudget& budget) {
  std::mutex mutex;
  std::vector<std::uint64_t> taken;
  for_each_chunk(
      options,
      [&budget](std::uint64_t chunk) {
        return Made{chunk, budget.reserve(chunk, "a chunk")};
      },
      [&](std::uint64_t chunk, const Made& made) {
        EXPECT_EQ(made.chunk, chunk);
        const std::lock_guard lock(mutex);
        taken.push_back(chunk);
      });
  return taken;
}

std::vector<std::uint64_t> ascending(std::uint64_t count) {
  std::vector<std::uint64_t> numbers;
  for (std::uint64_t i = 0; i < count; ++i) numbers.push_back(i);
  return numbers;
}

TEST(ChunkLoop, TakesEachChunkOnceAndInOrderWhereAsked) {
  for (std::uint64_t chunks : {0, 1, 2, 500}) {
    for (std::uint64_t at_once : {1, 2, 7}) {
      MemoryBudget budget(1 << 20);
      EXPECT_EQ(taken({chunks, at_once, true}, budget), ascending(chunks));
      auto any = taken({chunks, at_once, false}, budget);
      std::sort(any.begin(), any.end());
      EXPECT_EQ(any, ascending(chunks));
      EXPECT_EQ(budget.used(), 0U);
    }
  }
}

TEST(ChunkLoop, MakesOneByOneWhatDoesNotFitSideBySide) {
  for (const bool in_order : {true, false}) {
    MemoryBudget budget(499);  // the last chunk alone
    auto found = taken({500, 4, in_order}, budget);
    if (!in_order) std::sort(found.begin(), found.end());
    EXPECT_EQ(found, ascending(500));
    EXPECT_THROW(taken({501, 4, in_order}, budget), BudgetError);
    EXPECT_EQ(budget.used(), 0U);
  }
}

TEST(ChunkLoop, EndsWithTheErrorOfAChunk) {
  for (const bool in_order : {true, false}) {
    std::atomic<int> takes = 0;
    const auto make = [](std::uint64_t chunk) { return chunk; };
    const auto take = [&takes](std::uint64_t chunk, std::uint64_t) {
      if (chunk == 40) throw std::runtime_error("disk full");
      ++takes;
    };
    EXPECT_THROW(for_each_chunk({1000, 4, in_order}, make, take), std::runtime_error);
    EXPECT_LT(takes, 1000);
    if (in_order) {
      EXPECT_EQ(takes, 40);
    }
  }
}

TEST(ChunkLoop, RunsAsManyAsMemoryAndThreadsAllow) {
  MemoryBudget budget(1000);
  EXPECT_EQ(chunks_at_once(2000, budget), 1U);
  EXPECT_EQ(chunks_at_once(0, budget), threads_in_use());
  EXPECT_EQ(chunks_at_once(500, budget), std::min(2U, threads_in_use()));
}

}  // namespace
}  // namespace stream_recon
