// A pole as it is stored: the empty ball of a tetrahedron that is a pole of one of its samples.
//
// Thread rule: a value. Memory: 56 bytes, on disk as in memory (docs/formats.md).
#pragma once

#include <array>
#include <cstdint>
#include <tuple>
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
  bool has_ball_of(const Pole& other) const {
    return centre == other.centre && radius == other.radius;
  }
};

static_assert(sizeof(Pole) == 56 && std::is_trivially_copyable_v<Pole>);

/// The order of the store.
struct PoleByName {
  Pole pole;
  friend bool operator<(const PoleByName& a, const PoleByName& b) {
    return a.pole.tetrahedron < b.pole.tetrahedron;
  }
};

/// Equal balls beside each other, those of one tetrahedron too.
struct PoleByBall {
  Pole pole;
  friend bool operator<(const PoleByBall& a, const PoleByBall& b) { return a.key() < b.key(); }

 private:
  std::tuple<const double&, const double&, const double&, const double&, const NodeKey&> key()
      const {
    return std::tie(pole.centre.x, pole.centre.y, pole.centre.z, pole.radius, pole.tetrahedron);
  }
};

}  // namespace stream_recon
