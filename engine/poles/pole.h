// A pole as it is stored: the empty ball of a tetrahedron that is a pole of one of its samples.
//
// Thread rule: a value. Memory: 56 bytes, on disk as in memory (docs/formats.md).
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <type_traits>

#include "engine/labels/evidence_records.h"
#include "spatial/point.h"

namespace stream_recon {

struct Pole {
  NodeKey tetrahedron;   ///< of several with this ball, the lowest
  float separation = 0;  ///< largest angle at the centre between two of its samples, degrees
  std::uint8_t is_inside = 0;
  std::array<std::uint8_t, 3> unused{};
  Point3 centre;      ///< units of the input
  double radius = 0;  ///< finite

  std::uint32_t lowest_rank() const { return tetrahedron.ranks[0]; }
};

static_assert(sizeof(Pole) == 56 && std::is_trivially_copyable_v<Pole>);

/// The order of the store.
struct PoleByName {
  Pole pole;
  friend bool operator<(const PoleByName& a, const PoleByName& b) {
    return a.pole.tetrahedron < b.pole.tetrahedron;
  }
};

/// Equal balls beside each other, those of one tetrahedron too. Balls are equal if centre and
/// radius are, rounded to multiples of the tolerance.
struct PoleByBall {
  Pole pole;
  double tolerance = 0;  ///< the same for all; 0: as they are

  bool has_ball_of(const PoleByBall& other) const { return ball() == other.ball(); }
  friend bool operator<(const PoleByBall& a, const PoleByBall& b) {
    const auto x = a.ball();
    const auto y = b.ball();
    return x != y ? x < y : a.pole.tetrahedron < b.pole.tetrahedron;
  }

 private:
  std::array<double, 4> ball() const {
    return {rounded(pole.centre.x), rounded(pole.centre.y), rounded(pole.centre.z),
            rounded(pole.radius)};
  }
  double rounded(double length) const {
    return tolerance > 0 ? std::floor(length / tolerance + 0.5) : length;
  }
};

static_assert(sizeof(PoleByBall) == 64 && std::is_trivially_copyable_v<PoleByBall>);

}  // namespace stream_recon
