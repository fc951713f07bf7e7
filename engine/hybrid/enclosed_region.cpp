#include "engine/hybrid/enclosed_region.h"

#include <algorithm>

namespace stream_recon {

std::optional<std::vector<std::uint32_t>> enclosed_region(const CrustMesh& crust,
                                                          const std::vector<bool>& is_walked) {
  std::vector<std::uint32_t> region;
  std::vector<bool> is_inside(crust.triangles().size());
  const auto enter = [&](std::uint32_t triangle) {
    if (is_inside[triangle]) return;
    is_inside[triangle] = true;
    region.push_back(triangle);
  };
  for (std::uint32_t side = 0; side < crust.side_count(); ++side) {
    if (is_walked[side]) enter(side / 3);
  }
  for (std::size_t i = 0; i < region.size(); ++i) {
    for (std::uint32_t side = 3 * region[i]; side < 3 * region[i] + 3; ++side) {
      if (is_walked[side]) continue;
      const std::uint32_t beyond = crust.opposite(side);
      if (beyond == kNoSide || is_walked[beyond]) return std::nullopt;
      enter(beyond / 3);
    }
  }
  std::sort(region.begin(), region.end());
  return region;
}

}  // namespace stream_recon
