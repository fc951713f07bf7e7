// What is known of holes of the gamma shape, on its way through files and sorts.
//
// A hole is a piece of the solid's facets that the gamma shape lacks: those hang together at edges.
// Thread rule: values. Memory: 24, 8, 32, 136 and 16 bytes, on disk as in memory (docs/formats.md).
#pragma once

#include <array>
#include <cstdint>
#include <tuple>
#include <type_traits>

#include "engine/crust/crust_records.h"
#include "engine/surface/facet_record.h"
#include "spatial/point.h"

namespace stream_recon {

/// A facet of the solid in a hole.
struct HoleFill {
  std::uint32_t hole = 0;                ///< its number
  std::array<std::uint32_t, 3> ranks{};  ///< ascending
  float delta = 0;                       ///< as FacetRecord's, and what follows
  std::uint16_t closure = 0;
  std::int8_t facing = 0;
  std::uint8_t unused = 0;

  friend bool operator<(const HoleFill& a, const HoleFill& b) {
    return std::tie(a.hole, a.ranks) < std::tie(b.hole, b.ranks);
  }
};

/// That a sample is a corner of a hole's fills.
struct HoleSample {
  std::uint32_t rank = 0;
  std::uint32_t hole = 0;

  friend bool operator==(const HoleSample&, const HoleSample&) = default;
  friend bool operator<(const HoleSample& a, const HoleSample& b) {
    return std::tie(a.rank, a.hole) < std::tie(b.rank, b.hole);
  }
};

/// The same, with the sample's place.
struct HolePoint {
  std::uint32_t hole = 0;
  std::uint32_t rank = 0;
  Point3 point;

  friend bool operator<(const HolePoint& a, const HolePoint& b) {
    return std::tie(a.hole, a.rank) < std::tie(b.hole, b.rank);
  }
};

/// A triangle of the crust near a hole.
struct HoleCrust {
  std::uint32_t hole = 0;
  std::array<CrustVertexName, 3> names{};  ///< counterclockwise from outside
  std::array<Point3, 3> points{};  ///< x is not a number where only the name tells the place

  friend bool operator<(const HoleCrust& a, const HoleCrust& b) {
    return std::tie(a.hole, a.names) < std::tie(b.hole, b.names);
  }
};

/// A facet of the surface, not of the hole, with two or three of the hole's samples.
struct OuterFacet {
  std::uint32_t hole = 0;
  std::array<std::uint32_t, 3> ranks{};  ///< ascending

  friend bool operator<(const OuterFacet& a, const OuterFacet& b) {
    return std::tie(a.hole, a.ranks) < std::tie(b.hole, b.ranks);
  }
};

/// Of a facet of the surface.
inline std::array<std::uint32_t, 3> ranks_of(const FacetRecord& facet) {
  return {static_cast<std::uint32_t>(facet.ranks[0]), static_cast<std::uint32_t>(facet.ranks[1]),
          static_cast<std::uint32_t>(facet.ranks[2])};
}

static_assert(sizeof(HoleFill) == 24 && std::is_trivially_copyable_v<HoleFill>);
static_assert(sizeof(HoleSample) == 8 && std::is_trivially_copyable_v<HoleSample>);
static_assert(sizeof(HolePoint) == 32 && std::is_trivially_copyable_v<HolePoint>);
static_assert(sizeof(OuterFacet) == 16 && std::is_trivially_copyable_v<OuterFacet>);
static_assert(sizeof(HoleCrust) == 136 && std::is_trivially_copyable_v<HoleCrust>);

inline constexpr std::size_t kHoleBlock = std::size_t{128} << 10;

}  // namespace stream_recon
