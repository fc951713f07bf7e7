// A pole on its way from its window to the store: its tetrahedron with how the label will be found,
// and its ball, as two records, since exports have 32 bytes each.
//
// Thread rule: values. Memory: 32 bytes each, on disk as in memory (docs/formats.md).
#pragma once

#include <cstdint>
#include <type_traits>

#include "engine/labels/attachment.h"
#include "engine/labels/evidence_records.h"
#include "spatial/point.h"

namespace stream_recon {

struct PoleName {
  NodeKey tetrahedron;   ///< kInfiniteNode: the poles of samples of the hull, which have no ball
  Attachment node;       ///< of the tetrahedron, to a node of the window's table
  float separation = 0;  ///< largest angle at the centre between two of its samples, degrees
  std::uint32_t samples = 0;   ///< of the window, whose pole it is
  std::uint32_t is_small = 0;  ///< 1: too small to be a pole, and only counted
};

struct PoleBall {
  Point3 centre;
  double radius = 0;  ///< infinite where there is no ball
};

static_assert(sizeof(PoleName) == 32 && std::is_trivially_copyable_v<PoleName>);
static_assert(sizeof(PoleBall) == 32 && std::is_trivially_copyable_v<PoleBall>);

}  // namespace stream_recon
