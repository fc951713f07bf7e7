// Closure, the circumradius of a facet over the local spacing, in the two bytes a record has left.
//
// Guarantees: the upper half of the float32 (bfloat16), rounded to the nearest, ties to even: a
// relative error of at most 2^-8, powers of two exact; larger values never get a smaller code. Code
// 0 is unknown: of 0, negative values and no numbers; what is too small or too large for a code
// gets the least or the largest. Thread rule: pure functions.
#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>

namespace stream_recon {

inline constexpr std::uint16_t kUnknownClosure = 0;

constexpr std::uint16_t closure_code(float closure) {
  constexpr std::uint32_t kLeast = 1;
  constexpr std::uint32_t kLargest = 0x7f7f;  // below infinity
  if (!(closure > 0)) return kUnknownClosure;
  const auto bits = std::bit_cast<std::uint32_t>(closure);
  const std::uint32_t rounded = (bits + 0x7fff + ((bits >> 16) & 1)) >> 16;
  return static_cast<std::uint16_t>(std::clamp(rounded, kLeast, kLargest));
}

/// 0 where it is unknown.
constexpr float closure_of_code(std::uint16_t code) {
  return std::bit_cast<float>(std::uint32_t{code} << 16);
}

}  // namespace stream_recon
