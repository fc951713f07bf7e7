// A small seeded generator whose numbers are the same on every machine and library.
//
// Invariant: the sequence is a function of the seed alone. Memory: 8 bytes.
// Thread rule: one user. Source: SplitMix64, Steele, Lea, Flood, OOPSLA 2014.
#pragma once

#include <cmath>
#include <cstdint>

#include "spatial/point.h"
#include "spatial/simplex_digest.h"

namespace stream_recon {

class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}

  std::uint64_t bits() {
    const std::uint64_t value = SimplexDigest::splitmix64(state_);
    state_ += 0x9e3779b97f4a7c15U;
    return value;
  }

  /// Uniform in [0, 1), a multiple of 2^-53.
  double unit() { return static_cast<double>(bits() >> 11) * 0x1p-53; }

  /// Uniform in [-1, 1).
  double signed_unit() { return 2 * unit() - 1; }

  /// Uniform in the cube [0, 1)^3.
  Point3 in_cube() {
    const double x = unit();
    const double y = unit();
    return {x, y, unit()};
  }

  /// Uniform on the unit sphere.
  Point3 direction() {
    for (;;) {
      const double x = signed_unit();
      const double y = signed_unit();
      const double z = signed_unit();
      const double square = x * x + y * y + z * z;
      if (square > 1 || square < 1e-6) continue;
      const double length = std::sqrt(square);
      return {x / length, y / length, z / length};
    }
  }

 private:
  std::uint64_t state_;
};

}  // namespace stream_recon
