// A tetrahedron on its way from the windows to its chunk.
//
// Thread rule: a value. Memory: 32 bytes.
#pragma once

#include <array>
#include <type_traits>

#include "engine/windows/final_window.h"

namespace stream_recon {

struct TetrahedronRecord {
  /// Ascending, but for the last two, which change places where that makes the tetrahedron
  /// positively oriented: the first three are counterclockwise seen from the fourth.
  std::array<PointRank, 4> ranks{};
};

static_assert(sizeof(TetrahedronRecord) == 32 && std::is_trivially_copyable_v<TetrahedronRecord>);

}  // namespace stream_recon
