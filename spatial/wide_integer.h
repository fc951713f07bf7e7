// Signed integers of a fixed number of 64-bit limbs: the exact arithmetic of the predicates.
//
// Guarantees: a product has as many limbs as its factors together and never overflows; a sum has as
// many as the longer of its terms, and the caller sees to it that the value fits. Everything is on
// the stack. Cost: a product of m and n limbs takes m n multiplications of the processor.
// Source: Knuth, The Art of Computer Programming 2, section 4.3.1, algorithms A and M; signs as in
// Warren, Hacker's Delight, section 8-1.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cassert>
#include <cmath>
#include <cstdint>

namespace stream_recon {

template <int kLimbs>
class WideInteger {
 public:
  WideInteger() = default;

  /// \pre value is an integer below 2^(64 kLimbs - 1) in magnitude
  static WideInteger of(double value) {
    assert(std::fabs(value) < std::ldexp(1.0, 64 * kLimbs - 1));
    WideInteger result;
    if (std::fabs(value) < 0x1p63) {
      const auto small = static_cast<std::int64_t>(value);
      result.limbs_.fill(small < 0 ? ~std::uint64_t{0} : 0);
      result.limbs_[0] = static_cast<std::uint64_t>(small);
      return result;
    }
    if constexpr (kLimbs > 1) {
      const auto bits = std::bit_cast<std::uint64_t>(value);
      constexpr auto kImplicitBit = std::uint64_t{1} << 52;
      const std::uint64_t mantissa = (bits & (kImplicitBit - 1)) | kImplicitBit;
      const int places = static_cast<int>(bits >> 52 & 0x7ff) - 1075;
      const int limb = places / 64;
      const int shift = places % 64;
      result.limbs_[limb] = mantissa << shift;
      if (shift > 11) result.limbs_[limb + 1] = mantissa >> (64 - shift);
    }
    return value < 0 ? WideInteger() - result : result;
  }

  bool is_negative() const { return limbs_[kLimbs - 1] >> 63 != 0; }

  int sign() const {
    if (is_negative()) return -1;
    return std::any_of(limbs_.begin(), limbs_.end(), [](std::uint64_t l) { return l != 0; });
  }

  template <int kOther>
  WideInteger<std::max(kLimbs, kOther)> operator+(const WideInteger<kOther>& other) const {
    return add(other, 0, 0);
  }
  /// Adds the complement and one.
  template <int kOther>
  WideInteger<std::max(kLimbs, kOther)> operator-(const WideInteger<kOther>& other) const {
    return add(other, ~std::uint64_t{0}, 1);
  }

  template <int kOther>
  WideInteger<kLimbs + kOther> operator*(const WideInteger<kOther>& other) const {
    WideInteger<kLimbs + kOther> product;
    for (int i = 0; i < kLimbs; ++i) {
      Double carry = 0;
      for (int j = 0; j < kOther; ++j) {
        carry += Double{limbs_[i]} * other.limbs_[j] + product.limbs_[i + j];
        product.limbs_[i + j] = static_cast<std::uint64_t>(carry);
        carry >>= 64;
      }
      product.limbs_[i + kOther] = static_cast<std::uint64_t>(carry);
    }
    // So far a negative factor counted as itself plus 2^(64 limbs).
    if (is_negative()) product.subtract_at(kLimbs, other);
    if (other.is_negative()) product.subtract_at(kOther, *this);
    return product;
  }

 private:
  template <int kOther>
  friend class WideInteger;
  __extension__ using Double = unsigned __int128;

  // The limb at a place, the sign's beyond the last.
  std::uint64_t limb(int place) const {
    if (place < kLimbs) return limbs_[place];
    return is_negative() ? ~std::uint64_t{0} : 0;
  }

  template <int kOther>
  WideInteger<std::max(kLimbs, kOther)> add(const WideInteger<kOther>& other, std::uint64_t flip,
                                            Double carry) const {
    WideInteger<std::max(kLimbs, kOther)> sum;
    for (int i = 0; i < std::max(kLimbs, kOther); ++i) {
      carry += Double{limb(i)} + (other.limb(i) ^ flip);
      sum.limbs_[i] = static_cast<std::uint64_t>(carry);
      carry >>= 64;
    }
    return sum;
  }

  // Subtracts the limbs of `other`, as an unsigned number, from the limbs at `place` upwards.
  template <int kOther>
  void subtract_at(int place, const WideInteger<kOther>& other) {
    Double carry = 1;
    for (int i = 0; i < kOther; ++i) {
      carry += Double{limbs_[place + i]} + ~other.limbs_[i];
      limbs_[place + i] = static_cast<std::uint64_t>(carry);
      carry >>= 64;
    }
  }

  std::array<std::uint64_t, kLimbs> limbs_{};
};

}  // namespace stream_recon
