#include "tools/preview/components.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace stream_recon {
namespace {

constexpr std::uint32_t kRoot = std::uint32_t{1} << 31;

bool is_root(std::uint32_t link) {
  return (link & kRoot) != 0;
}

}  // namespace

Components::Components(std::uint64_t points) {
  if (points > kRoot - 1) throw std::length_error("more points than components can tell apart");
  links_.assign(points, kRoot | 1);
}

std::uint32_t Components::root(std::uint32_t point) {
  while (!is_root(links_[point])) {
    const std::uint32_t next = links_[point];
    if (is_root(links_[next])) return next;
    links_[point] = links_[next];
    point = links_[next];
  }
  return point;
}

void Components::join(const std::array<std::uint64_t, 3>& triangle) {
  std::uint32_t a = root(static_cast<std::uint32_t>(triangle[0]));
  for (const std::uint64_t corner : {triangle[1], triangle[2]}) {
    std::uint32_t b = root(static_cast<std::uint32_t>(corner));
    if (a == b) continue;
    if (b < a) std::swap(a, b);
    links_[a] += links_[b] & ~kRoot;
    links_[b] = a;
  }
}

void Components::rank() {
  std::vector<std::uint32_t> roots;
  for (std::uint32_t i = 0; i < links_.size(); ++i) {
    if (is_root(links_[i]) && links_[i] != (kRoot | 1)) roots.push_back(i);
  }
  std::stable_sort(roots.begin(), roots.end(),
                   [this](std::uint32_t a, std::uint32_t b) { return links_[a] > links_[b]; });
  sizes_.reserve(roots.size());
  for (const std::uint32_t root : roots) {
    const auto rank = static_cast<std::uint32_t>(sizes_.size());
    sizes_.push_back(links_[root] & ~kRoot);
    links_[root] = kRoot | rank;
  }
}

std::uint32_t Components::rank_of(std::uint64_t point) {
  return links_[root(static_cast<std::uint32_t>(point))] & ~kRoot;
}

}  // namespace stream_recon
