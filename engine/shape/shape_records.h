// A face of the power shape on its way from its window to the medial axis.
//
// Thread rule: a value. Memory: 12 bytes, on disk as in memory (docs/formats.md).
#pragma once

#include <array>
#include <type_traits>

#include "engine/power/pole_finder.h"

namespace stream_recon {

struct ShapeFace {
  /// Numbers, ascending; of an edge that no triangle has, two and kNoPole.
  std::array<PoleNumber, 3> poles{};

  bool is_edge() const { return poles[2] == kNoPole; }

  friend bool operator<(const ShapeFace& a, const ShapeFace& b) { return a.poles < b.poles; }
};

static_assert(sizeof(ShapeFace) == 12 && std::is_trivially_copyable_v<ShapeFace>);

}  // namespace stream_recon
