// The budget's arithmetic, and sizes as people write them.

#include "engine/budget.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <utility>
#include <vector>

#include "engine/parallel.h"
#include "engine/process_memory.h"
#include "engine/size_text.h"

namespace stream_recon {
namespace {

using testing::HasSubstr;

constexpr std::uint64_t kMebi = std::uint64_t{1} << 20;

TEST(MemoryBudget, GivesBackWhatGoesAndKeepsThePeak) {
  MemoryBudget budget(100);
  {
    const Reservation first = budget.reserve(60, "first");
    Reservation second = budget.reserve(40, "second");
    EXPECT_EQ(budget.available(), 0U);
    second.resize(10);
    EXPECT_EQ(budget.used(), 70U);
  }
  EXPECT_EQ(budget.used(), 0U);
  EXPECT_EQ(budget.peak(), 100U);
}

TEST(MemoryBudget, RefusesWithTheNumbersAndChangesNothing) {
  MemoryBudget budget(100 * kMebi);
  Reservation held = budget.reserve(80 * kMebi, "held");
  try {
    (void)budget.reserve(30 * kMebi, "the window");
    FAIL() << "took more than there is";
  } catch (const BudgetError& e) {
    EXPECT_THAT(e.what(), HasSubstr("the window needs 30.0 MiB"));
    EXPECT_THAT(e.what(), HasSubstr("--memory 110M"));
  }
  EXPECT_THROW(held.resize(101 * kMebi), BudgetError);
  EXPECT_EQ(budget.used(), 80 * kMebi);
  EXPECT_EQ(held.bytes(), 80 * kMebi);
}

TEST(MemoryBudget, MovedReservationsAreCountedOnce) {
  MemoryBudget budget(100);
  Reservation a = budget.reserve(30, "a");
  Reservation b = budget.reserve(50, "b");
  a = std::move(b);
  EXPECT_EQ(budget.used(), 50U);
  const Reservation c(std::move(a));
  EXPECT_EQ(budget.used(), 50U);
  EXPECT_EQ(c.bytes(), 50U);
}

TEST(MemoryBudget, HoldsWhenAllThreadsReserveAtOnce) {
  MemoryBudget budget(1000);
  parallel_for_ranges(10000, 1, [&budget](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      try {
        Reservation r = budget.reserve(1 + i % 400, "a task");
        r.resize(i % 7);
      } catch (const BudgetError&) {
        continue;
      }
    }
  });
  EXPECT_EQ(budget.used(), 0U);
  EXPECT_LE(budget.peak(), 1000U);
}

TEST(SizeText, ReadsWhatPeopleWrite) {
  const std::vector<std::pair<const char*, std::uint64_t>> sizes{
      {"512M", 512 * kMebi},  {"1G", 1024 * kMebi},
      {"1.5G", 1536 * kMebi}, {"64m", 64 * kMebi},
      {"1GiB", 1024 * kMebi}, {"100MB", 100 * kMebi},
      {"4096", 4096},         {"0.5k", 512},
      {"2T", kMebi << 21},    {"7B", 7}};
  for (const auto& [text, bytes] : sizes) EXPECT_EQ(parse_size(text), bytes) << text;
}

TEST(SizeText, RefusesEverythingElse) {
  for (const char* text : {"", "M", "0", "0M", "-1G", "1X", "1 G", "1GG", "1e3M", "inf", "nan",
                           "99999999T", "1Gi", "1,5G", "0x10"}) {
    EXPECT_EQ(parse_size(text), std::nullopt) << text;
  }
}

TEST(SizeText, ArgumentsRoundUpToWholeMebibytes) {
  EXPECT_EQ(size_argument(kMebi), "1M");
  EXPECT_EQ(size_argument(kMebi + 1), "2M");
  EXPECT_EQ(parse_size(size_argument(12345678)).value(), 12 * kMebi);
  EXPECT_EQ(size_text(1536 * kMebi), "1.5 GiB");
  EXPECT_EQ(size_text(17), "17 bytes");
}

TEST(ProcessMemory, FollowsWhatIsAllocatedAndFreed) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  GTEST_SKIP() << "the sanitizers keep freed memory to catch late uses of it";
#endif
  make_allocator_return_memory();
  const std::uint64_t before = resident_bytes();
  {
    std::vector<char> block(64 * kMebi, 1);
    EXPECT_GE(resident_bytes(), before + 60 * kMebi + static_cast<std::uint64_t>(block[7] - 1));
  }
  trim_allocator();
  EXPECT_LE(resident_bytes(), before + 8 * kMebi);
  EXPECT_GE(peak_resident_bytes(), before + 60 * kMebi);
  EXPECT_GE(physical_memory_bytes(), peak_resident_bytes());
}

}  // namespace
}  // namespace stream_recon
