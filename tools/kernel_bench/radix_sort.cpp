#include "tools/kernel_bench/radix_sort.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace stream_recon {
namespace {

constexpr int kDigitBits = 11;
constexpr int kDigits = 6;  // 66 bits
constexpr std::size_t kBuckets = std::size_t{1} << kDigitBits;

using Histogram = std::array<std::size_t, kBuckets>;

std::size_t digit_of(const KeyedNumber& entry, int digit) {
  return (entry.key >> (digit * kDigitBits)) & (kBuckets - 1);
}

std::vector<Histogram> count_digits(const std::vector<KeyedNumber>& entries) {
  std::vector<Histogram> counts(kDigits, Histogram{});
  for (const KeyedNumber& entry : entries)
    for (int digit = 0; digit < kDigits; ++digit) ++counts[digit][digit_of(entry, digit)];
  return counts;
}

}  // namespace

void radix_sort(std::vector<KeyedNumber>& entries) {
  std::vector<Histogram> counts = count_digits(entries);
  std::vector<KeyedNumber> other(entries.size());
  for (int digit = 0; digit < kDigits; ++digit) {
    Histogram& next = counts[digit];
    if (std::find(next.begin(), next.end(), entries.size()) != next.end()) continue;
    std::size_t start = 0;
    for (std::size_t& bucket : next) {
      const std::size_t size = bucket;
      bucket = start;
      start += size;
    }
    for (const KeyedNumber& entry : entries) other[next[digit_of(entry, digit)]++] = entry;
    entries.swap(other);
  }
}

}  // namespace stream_recon
