#include "engine/surface/edge_uses.h"

#include <functional>

#include "engine/parallel.h"

namespace stream_recon {

std::vector<EdgeUse> sorted_edge_uses(std::span<const LocalTriangle> triangles) {
  std::vector<EdgeUse> uses;
  uses.reserve(3 * triangles.size());
  for (std::uint32_t t = 0; t < triangles.size(); ++t) {
    const LocalTriangle& v = triangles[t];
    uses.push_back({v[0], v[1], 3 * t});
    uses.push_back({v[1], v[2], 3 * t + 1});
    uses.push_back({v[0], v[2], 3 * t + 2});
  }
  parallel_sort(uses.begin(), uses.end(), std::less<>());
  return uses;
}

}  // namespace stream_recon
