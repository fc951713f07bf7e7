// A facet that may be part of the solid's surface: its window does not know whether its two
// tetrahedra lie on the same side. Or a sample's pair of poles, of which it should be known.
//
// Thread rule: values. Memory: 32 bytes, on disk as in memory (docs/formats.md).
#pragma once

#include <array>
#include <cstdint>
#include <type_traits>

#include "engine/labels/attachment.h"
#include "engine/surface/closure_code.h"
#include "io/surface_writer.h"

namespace stream_recon {

struct CandidateFacet {
  std::array<std::uint32_t, 3> ranks{};  ///< ascending; three times the sample's of a pair of poles
  float delta = 0;                       ///< angle of the two balls, degrees
  /// Of the tetrahedron from whose outside the facet, in the order of its ranks, is seen
  /// counterclockwise: the position of a node in the window's table, and whether it is opposite.
  Attachment behind;
  Attachment before;  ///< of the other one
  std::uint16_t closure = kUnknownClosure;
  TriangleSource source{};
  std::uint8_t unused = 0;
  std::uint32_t unused_too = 0;

  bool is_pole_pair() const { return ranks[0] == ranks[1]; }
};

static_assert(sizeof(CandidateFacet) == 32 && std::is_trivially_copyable_v<CandidateFacet>);

}  // namespace stream_recon
