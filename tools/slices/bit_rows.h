// Rows of pixels that are smaller than a byte: the first pixel is in the highest bits.
#pragma once

#include <cstddef>
#include <span>

namespace stream_recon {

/// Fills `out` from pixels of 1, 2, 4 or 8 bits.
inline void widen_bits(const std::byte* row, unsigned bits, std::span<double> out) {
  const unsigned mask = (1U << bits) - 1;
  const std::size_t in_byte = 8 / bits;
  for (std::size_t x = 0; x < out.size(); ++x) {
    const auto shift = static_cast<unsigned>(8 - bits * (x % in_byte + 1));
    out[x] = std::to_integer<unsigned>(row[x / in_byte]) >> shift & mask;
  }
}

}  // namespace stream_recon
