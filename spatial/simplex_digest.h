// A digest of a set of simplices that does not depend on their order, so that results can be
// compared between programs, windows and threads.
//
// Guarantees: equal sets of simplices (as sets of input indices) have equal digests, in whatever
// order simplices and their vertices come; digests of disjoint parts add up.
// Thread rule: one writer; merge() joins the parts. Cost: a few nanoseconds a simplex, 8 bytes.
// Source: splitmix64 after Steele, Lea, Flood 2014 ("Fast splittable pseudorandom number
// generators", section 4).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>

namespace stream_recon {

class SimplexDigest {
 public:
  SimplexDigest() = default;
  /// \param value of another digest
  explicit SimplexDigest(std::uint64_t value) : sum_(value) {}

  /// Adds one simplex, its input indices in any order.
  template <std::size_t kCorners>
  void add(std::array<std::uint64_t, kCorners> corners) {
    sort_corners(corners);
    std::uint64_t hash = 0;
    for (const std::uint64_t corner : corners) hash = splitmix64(hash ^ corner);
    sum_ += hash;
  }

  void merge(const SimplexDigest& part) { sum_ += part.sum_; }

  std::uint64_t value() const { return sum_; }

  /// 16 lower-case hex digits.
  std::string hex() const {
    static constexpr char kDigits[] = "0123456789abcdef";
    std::string text(16, '0');
    for (int i = 0; i < 16; ++i) text[i] = kDigits[(sum_ >> (60 - 4 * i)) & 15];
    return text;
  }

  static constexpr std::uint64_t splitmix64(std::uint64_t x) {
    x += 0x9e3779b97f4a7c15U;
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9U;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebU;
    return x ^ (x >> 31);
  }

 private:
  /// By neighbours in turn: no branches, and for four corners one step more than the least.
  template <std::size_t kCorners>
  static void sort_corners(std::array<std::uint64_t, kCorners>& corners) {
    for (std::size_t end = kCorners - 1; end > 0; --end) {
      for (std::size_t i = 0; i < end; ++i) {
        const std::uint64_t a = corners[i];
        const std::uint64_t b = corners[i + 1];
        corners[i] = a < b ? a : b;
        corners[i + 1] = a < b ? b : a;
      }
    }
  }

  std::uint64_t sum_ = 0;
};

}  // namespace stream_recon
