#include "tools/check/boundary_rings.h"

#include <algorithm>
#include <utility>

namespace stream_recon {

void BoundaryRings::add(std::uint64_t vertex, std::span<const StarEdge> edges) {
  const auto degree = std::count_if(edges.begin(), edges.end(),
                                    [](const StarEdge& edge) { return edge.is_boundary(); });
  if (degree == 0) return;
  const std::uint32_t position = append(vertex);
  if (degree != 2) parents_[position] |= kBranches;
  for (const StarEdge& edge : edges) {
    if (edge.is_boundary() && edge.other < vertex) join(position_of(edge.other), position);
  }
}

std::uint32_t BoundaryRings::append(std::uint64_t vertex) {
  constexpr std::size_t kStep = std::size_t{1} << 14;
  if (count_ == kBranches) {
    throw BudgetError("more than 2^31 vertices on the boundary; split the mesh");
  }
  if (count_ == vertices_.capacity()) {
    memory_.resize((count_ + kStep) * (sizeof(std::uint64_t) + sizeof(std::uint32_t)));
    vertices_.reserve(count_ + kStep);
    parents_.reserve(count_ + kStep);
  }
  vertices_[count_] = vertex;
  parents_[count_] = count_;
  return count_++;
}

std::uint32_t BoundaryRings::position_of(std::uint64_t vertex) const {
  const std::uint64_t* const begin = vertices_.data();
  return static_cast<std::uint32_t>(std::lower_bound(begin, begin + count_, vertex) - begin);
}

std::uint32_t BoundaryRings::root_of(std::uint32_t position) const {
  while ((parents_[position] & ~kBranches) != position) {
    position = parents_[position] & ~kBranches;
  }
  return position;
}

void BoundaryRings::join(std::uint32_t a, std::uint32_t b) {
  const std::uint32_t root_a = root_of(a);
  const std::uint32_t root_b = root_of(b);
  const auto [low, high] = std::minmax(root_a, root_b);
  const std::uint32_t branches = (parents_[low] | parents_[high]) & kBranches;
  parents_[high] = low;
  parents_[low] = low | branches;
  // Paths are shortened from where the joins come.
  for (std::uint32_t at : {a, b}) {
    while (at != low) {
      const std::uint32_t next = parents_[at] & ~kBranches;
      parents_[at] = low;
      at = next;
    }
  }
}

BoundaryRings::Counts BoundaryRings::count() {
  Counts counts;
  for (std::uint32_t i = 0; i < count_; ++i) {
    if ((parents_[i] & ~kBranches) != i) continue;
    ++counts.rings;
    if ((parents_[i] & kBranches) == 0) ++counts.simple;
  }
  return counts;
}

}  // namespace stream_recon
