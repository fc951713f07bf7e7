// How finely and how widely the coordinates of a cloud are spread: what exact arithmetic needs to
// know about it, found in one streaming pass.
//
// Guarantees: every coordinate seen is a multiple of 2^unit_exponent and smaller in magnitude than
// 2^magnitude_exponent; weights, which are squares of lengths, count with half their exponents.
// Thread rule: one writer; merge() joins the parts. Cost: 8 bytes, about 5 ns a point.
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>

#include "spatial/point.h"

namespace stream_recon {

struct CoordinateRange {
  /// The predicates are of degree 5. With a unit of at least 2^-200 no product of five in their
  /// filters loses bits to underflow (5 * -200 - 53 >= -1074, the error bounds included), and with
  /// coordinates below 2^190 none overflows (5 * 190 + 8 bits of sums < 1023).
  static constexpr int kLeastUnit = -200;
  static constexpr int kMostMagnitude = 190;

  int unit_exponent = std::numeric_limits<int>::max();
  int magnitude_exponent = std::numeric_limits<int>::min();

  bool empty() const { return unit_exponent > magnitude_exponent; }

  /// \pre value is finite
  void extend(double value) { extend(value, 1); }
  void extend(const Point3& p) {
    extend(p.x);
    extend(p.y);
    extend(p.z);
  }
  void extend(const WeightedPoint3& p) {
    extend(p.point);
    extend(p.weight, 2);
  }

  void merge(const CoordinateRange& part) {
    unit_exponent = std::min(unit_exponent, part.unit_exponent);
    magnitude_exponent = std::max(magnitude_exponent, part.magnitude_exponent);
  }

  /// The power of two that brings all coordinates to where the predicates are exact (1 where they
  /// already are; multiplying by it is exact), or nothing if the cloud is too wide for any.
  std::optional<double> scale() const {
    if (empty()) return 1.0;
    if (magnitude_exponent - unit_exponent > kMostMagnitude - kLeastUnit) return std::nullopt;
    if (unit_exponent < kLeastUnit) return std::ldexp(1.0, kLeastUnit - unit_exponent);
    if (magnitude_exponent > kMostMagnitude) {
      return std::ldexp(1.0, kMostMagnitude - magnitude_exponent);
    }
    return 1.0;
  }

  /// Of the coordinates times a power of two. \pre power > 0
  CoordinateRange times(double power) const {
    CoordinateRange result = *this;
    if (empty()) return result;
    result.unit_exponent += std::ilogb(power);
    result.magnitude_exponent += std::ilogb(power);
    return result;
  }

  /// Whether the predicates are exact for coordinates as they are.
  bool is_safe() const { return scale() == 1.0; }

 private:
  /// The value is a quantity of the given degree in the unit of length.
  void extend(double value, int degree) {
    if (value == 0) return;
    const auto bits = std::bit_cast<std::uint64_t>(value);
    const int biased = static_cast<int>((bits >> 52) & 0x7ff);
    const std::uint64_t fraction = bits & ((std::uint64_t{1} << 52) - 1);
    const std::uint64_t mantissa = biased == 0 ? fraction : fraction | (std::uint64_t{1} << 52);
    const int last_place = std::max(biased, 1) - 1075;
    int low = last_place + std::countr_zero(mantissa);
    int high = last_place + static_cast<int>(std::bit_width(mantissa));
    if (degree == 2) {
      low = low >> 1;
      high = (high + 1) >> 1;
    }
    unit_exponent = std::min(unit_exponent, low);
    magnitude_exponent = std::max(magnitude_exponent, high);
  }
};

}  // namespace stream_recon
