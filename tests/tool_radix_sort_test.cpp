#include "tools/kernel_bench/radix_sort.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace stream_recon {
namespace {

void expect_sorted_stably(std::vector<KeyedNumber> entries) {
  std::vector<KeyedNumber> expected = entries;
  std::stable_sort(expected.begin(), expected.end(),
                   [](const KeyedNumber& a, const KeyedNumber& b) { return a.key < b.key; });
  radix_sort(entries);
  EXPECT_EQ(entries, expected);
}

TEST(RadixSort, AgreesWithStableSortForKeysOfEveryWidth) {
  for (int bits = 1; bits <= 64; ++bits) {
    SCOPED_TRACE("seed and bits " + std::to_string(bits));
    std::mt19937_64 random(bits);
    std::vector<KeyedNumber> entries(3000);
    for (std::uint32_t i = 0; i < entries.size(); ++i) entries[i] = {random() >> (64 - bits), i};
    expect_sorted_stably(entries);
  }
}

TEST(RadixSort, TakesNoneOneAndEqualKeys) {
  expect_sorted_stably({});
  expect_sorted_stably({{~std::uint64_t{0}, 7}});
  expect_sorted_stably({{5, 2}, {5, 1}, {5, 0}});
}

}  // namespace
}  // namespace stream_recon
