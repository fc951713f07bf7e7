// The rings that the boundary edges of a mesh form.
//
// A ring is a connected part of the boundary; it is simple if each of its vertices has two boundary
// edges. Vertices come in ascending order. Thread rule: one thread. Memory: 12 bytes a vertex on
// the boundary. Cost: a binary search an edge.
#pragma once

#include <cstdint>
#include <span>

#include "engine/budget.h"
#include "spatial/growable_array.h"
#include "tools/check/vertex_star.h"

namespace stream_recon {

class BoundaryRings {
 public:
  /// \throw BudgetError
  explicit BoundaryRings(MemoryBudget& budget) : memory_(budget.reserve(0, "boundary rings")) {}

  /// \pre vertices ascend from call to call \throw BudgetError
  void add(std::uint64_t vertex, std::span<const StarEdge> edges);

  struct Counts {
    std::uint64_t rings = 0;
    std::uint64_t simple = 0;
  };
  /// No more vertices.
  Counts count();

 private:
  static constexpr std::uint32_t kBranches = std::uint32_t{1} << 31;

  std::uint32_t append(std::uint64_t vertex);
  std::uint32_t position_of(std::uint64_t vertex) const;
  std::uint32_t root_of(std::uint32_t position) const;
  void join(std::uint32_t a, std::uint32_t b);

  Reservation memory_;
  GrowableArray<std::uint64_t> vertices_;
  /// Never above the position; the highest bit of a root says that the ring is not simple.
  GrowableArray<std::uint32_t> parents_;
  std::uint32_t count_ = 0;
};

}  // namespace stream_recon
