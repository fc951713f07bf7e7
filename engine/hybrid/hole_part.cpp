#include "engine/hybrid/hole_part.h"

#include <cstddef>

namespace stream_recon {

HolePart hole_without(const Hole& hole, const std::vector<bool>& is_kept) {
  HolePart part;
  std::vector<bool> is_used(hole.points.size());
  for (std::size_t i = 0; i < hole.fills.size(); ++i) {
    if (is_kept[i]) continue;
    part.hole.fills.push_back(hole.fills[i]);
    for (const std::uint32_t corner : hole.fills[i]) is_used[corner] = true;
  }
  std::vector<std::uint32_t> positions(hole.points.size());
  for (std::uint32_t v = 0; v < hole.points.size(); ++v) {
    if (!is_used[v]) continue;
    positions[v] = static_cast<std::uint32_t>(part.numbers.size());
    part.numbers.push_back(v);
    part.hole.points.push_back(hole.points[v]);
  }
  for (HoleTriangle& fill : part.hole.fills) {
    for (std::uint32_t& corner : fill) corner = positions[corner];
  }
  return part;
}

}  // namespace stream_recon
