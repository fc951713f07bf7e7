// Memory over time: bounded, in order, and no peak that was seen gets lost.

#include "engine/memory_trace.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <thread>
#include <vector>

namespace stream_recon {
namespace {

TEST(SampleThinner, KeepsOrderAndTheHighestWhateverTheNumber) {
  std::mt19937 random(5);
  for (const int count : {1, 7, 8, 9, 100, 5000}) {
    SCOPED_TRACE(count);
    SampleThinner thinner(8);
    std::uint64_t highest = 0;
    for (int i = 0; i < count; ++i) {
      const std::uint64_t bytes = random() % 100000;
      highest = std::max(highest, bytes);
      thinner.add({static_cast<double>(i), bytes});
    }
    const auto& samples = thinner.samples();
    EXPECT_LE(samples.size(), 8U);
    EXPECT_GE(samples.size(), std::min<std::size_t>(4, count));
    EXPECT_TRUE(std::is_sorted(samples.begin(), samples.end(),
                               [](const auto& a, const auto& b) { return a.seconds < b.seconds; }));
    const auto top = std::max_element(samples.begin(), samples.end(), [](auto& a, auto& b) {
      return a.resident_bytes < b.resident_bytes;
    });
    EXPECT_EQ(top->resident_bytes, highest);
  }
}

TEST(MemoryTrace, SeesMemoryComeAndGo) {
  constexpr std::size_t kBlock = std::size_t{64} << 20;
  const auto pause = [] { std::this_thread::sleep_for(std::chrono::milliseconds(100)); };
  MemoryTrace trace;
  pause();
  {
    std::vector<char> block(kBlock, 1);
    pause();
    EXPECT_EQ(block[kBlock / 2], 1);
  }
  pause();
  const auto samples = trace.stop();
  ASSERT_GE(samples.size(), 4U);
  EXPECT_EQ(samples.front().seconds, 0);
  EXPECT_GE(samples.back().seconds, 0.3);
  std::uint64_t highest = 0;
  for (const auto& sample : samples) highest = std::max(highest, sample.resident_bytes);
  EXPECT_GT(highest, samples.front().resident_bytes + kBlock * 9 / 10);
}

TEST(MemoryTrace, EndsAtOnce) {
  const auto start = std::chrono::steady_clock::now();
  for (int i = 0; i < 20; ++i) MemoryTrace{};
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(2));
}

}  // namespace
}  // namespace stream_recon
