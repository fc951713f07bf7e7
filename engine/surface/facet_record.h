// A facet of the surface on its way from the windows to its chunk.
//
// Thread rule: a value. Memory: 32 bytes.
#pragma once

#include <array>
#include <cstdint>
#include <tuple>
#include <type_traits>

#include "engine/surface/closure_code.h"
#include "engine/windows/final_window.h"
#include "io/surface_writer.h"

namespace stream_recon {

/// Which way a facet in the order of its ranks faces, where that is known.
enum class Facing : std::int8_t { kInward = -1, kUnknown = 0, kOutward = 1 };

struct FacetRecord {
  std::array<PointRank, 3> ranks{};  ///< ascending
  float delta = 0;                   ///< angle of the two balls, degrees
  TriangleSource source{};
  /// kOutward: counterclockwise when seen from outside: outside the solid, or, where there is none,
  /// outside the convex hull, of which it is a facet.
  Facing facing = Facing::kUnknown;
  std::uint16_t closure = kUnknownClosure;  ///< closure_code.h

  /// Of a crust two facets may have the same corners, and face each other.
  friend bool operator<(const FacetRecord& a, const FacetRecord& b) {
    return std::tie(a.ranks, a.facing, a.delta) < std::tie(b.ranks, b.facing, b.delta);
  }
};

static_assert(sizeof(FacetRecord) == 32 && std::is_trivially_copyable_v<FacetRecord>);

}  // namespace stream_recon
