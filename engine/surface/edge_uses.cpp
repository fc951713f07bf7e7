#include "engine/surface/edge_uses.h"

#include <algorithm>

#include "engine/surface/buckets.h"

namespace stream_recon {
namespace {

std::uint32_t vertex_count(std::span<const LocalTriangle> triangles) {
  std::uint32_t count = 0;
  for (const LocalTriangle& v : triangles) count = std::max(count, v[2] + 1);
  return count;
}

}  // namespace

std::vector<EdgeUse> sorted_edge_uses(std::span<const LocalTriangle> triangles) {
  Buckets by_low(vertex_count(triangles));
  for (const LocalTriangle& v : triangles) {
    by_low.count(v[0]);
    by_low.count(v[0]);
    by_low.count(v[1]);
  }
  by_low.start();
  std::vector<EdgeUse> uses(3 * triangles.size());
  for (std::uint32_t t = 0; t < triangles.size(); ++t) {
    const LocalTriangle& v = triangles[t];
    uses[by_low.slot(v[0])] = {v[0], v[1], 3 * t};
    uses[by_low.slot(v[1])] = {v[1], v[2], 3 * t + 1};
    uses[by_low.slot(v[0])] = {v[0], v[2], 3 * t + 2};
  }
  by_low.for_each([&uses](std::uint32_t begin, std::uint32_t end) {
    std::sort(uses.begin() + begin, uses.begin() + end);
  });
  return uses;
}

}  // namespace stream_recon
