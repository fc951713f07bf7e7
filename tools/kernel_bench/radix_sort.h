// Sorts points' numbers by 64-bit keys in core.
//
// Guarantees: stable, so that equal keys keep the order of their numbers.
// Memory: 16 bytes an entry beside the entries. Cost: six passes, fewer where digits never differ.
// Source: Knuth, The Art of Computer Programming 3, 5.2.5 (least significant digit first).
#pragma once

#include <cstdint>
#include <vector>

namespace stream_recon {

struct KeyedNumber {
  std::uint64_t key = 0;
  std::uint32_t number = 0;

  friend bool operator==(const KeyedNumber&, const KeyedNumber&) = default;
};

void radix_sort(std::vector<KeyedNumber>& entries);

}  // namespace stream_recon
