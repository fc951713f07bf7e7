#include "engine/hybrid/hole_rings.h"

#include <algorithm>
#include <cstddef>

#include "engine/hybrid/side_pairs.h"

namespace stream_recon {

std::vector<std::vector<std::uint32_t>> hole_rings(const Hole& hole) {
  const std::vector<std::uint32_t> opposite = pair_sides(hole.fills);
  const auto from = [&](std::uint32_t side) { return hole.fills[side / 3][side % 3]; };
  std::vector<std::uint32_t> border;
  for (std::uint32_t side = 0; side < opposite.size(); ++side) {
    if (opposite[side] == kNoSide) border.push_back(side);
  }
  std::sort(border.begin(), border.end(), [&](std::uint32_t a, std::uint32_t b) {
    const HoleEdge edge_a{from(a), from(next_side(a))};
    const HoleEdge edge_b{from(b), from(next_side(b))};
    return edge_a != edge_b ? edge_a < edge_b : a < b;
  });
  std::vector<std::vector<std::uint32_t>> rings;
  std::vector<bool> is_done(opposite.size());
  for (const std::uint32_t first : border) {
    if (is_done[first]) continue;
    std::vector<std::uint32_t>& ring = rings.emplace_back();
    std::uint32_t side = first;
    do {
      is_done[side] = true;
      ring.push_back(from(side));
      // Around the fan, to the border at its other end.
      side = next_side(side);
      while (opposite[side] != kNoSide) side = next_side(opposite[side]);
    } while (side != first);
  }
  return rings;
}

}  // namespace stream_recon
