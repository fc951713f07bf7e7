#include "spatial/ring_triangulation.h"

#include <tuple>
#include <utility>

#include "spatial/vector.h"

namespace stream_recon {
namespace {

struct Cost {
  std::uint32_t foreign = 0;  ///< inner edges that are not welcome
  double area = 0;            ///< twice

  friend bool operator<(const Cost& a, const Cost& b) {
    return std::tie(a.foreign, a.area) < std::tie(b.foreign, b.area);
  }
};

double twice_area(const Point3& a, const Point3& b, const Point3& c) {
  return length(cross(minus(b, a), minus(c, a)));
}

/// Of the part of the ring between two places: its least cost, and the corner opposite their edge.
struct Part {
  Cost cost;
  std::uint32_t apex = 0;
};

}  // namespace

std::vector<std::array<std::uint32_t, 3>> ring_triangulation(std::span<const Point3> ring,
                                                             const IsWelcome& is_welcome) {
  const auto n = static_cast<std::uint32_t>(ring.size());
  std::vector<Part> parts(std::size_t{n} * n);
  const auto part = [&](std::uint32_t from, std::uint32_t to) -> Part& {
    return parts[std::size_t{from} * n + to];
  };
  for (std::uint32_t span = 2; span < n; ++span) {
    for (std::uint32_t from = 0; from + span < n; ++from) {
      const std::uint32_t to = from + span;
      const bool is_inner = span + 1 < n;
      const std::uint32_t own = is_inner && is_welcome && !is_welcome(from, to) ? 1 : 0;
      Part& best = part(from, to);
      for (std::uint32_t apex = from + 1; apex < to; ++apex) {
        const Cost one = part(from, apex).cost;
        const Cost two = part(apex, to).cost;
        const Cost cost{one.foreign + two.foreign + own,
                        one.area + two.area + twice_area(ring[from], ring[apex], ring[to])};
        if (best.apex == 0 || cost < best.cost) best = {cost, apex};
      }
    }
  }
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> open{{0, n - 1}};
  while (!open.empty()) {
    const auto [from, to] = open.back();
    open.pop_back();
    if (to - from < 2) continue;
    const std::uint32_t apex = part(from, to).apex;
    triangles.push_back({from, apex, to});
    open.emplace_back(apex, to);
    open.emplace_back(from, apex);
  }
  return triangles;
}

}  // namespace stream_recon
