#include "spatial/local_spacing.h"

#include <algorithm>
#include <limits>

#include "spatial/vector.h"

namespace stream_recon {

float local_spacing(std::span<const Point3> neighbors) {
  if (neighbors.empty()) return 1;
  using Limits = std::numeric_limits<float>;
  const Point3& last = neighbors[std::min(neighbors.size(), kSpacingNeighbors) - 1];
  return static_cast<float>(std::clamp(length(last), double{Limits::min()}, double{Limits::max()}));
}

}  // namespace stream_recon
