// What hangs together in a mesh that is never in memory: union-find over the points' numbers.
//
// First join() all triangles, then rank(); a component's rank is its place by size, the larger
// first, equal ones by their lowest point. So ranks are a function of the mesh alone.
// Memory: 4 bytes a point of the mesh, 12 a component. Thread rule: one thread. Cost: a few
// look-ups a triangle. Source: Tarjan, JACM 1975, with path halving; the lowest point is the root.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace stream_recon {

class Components {
 public:
  /// Numbers are below `points`. \throw std::length_error more than 2^31
  explicit Components(std::uint64_t points);

  void join(const std::array<std::uint64_t, 3>& triangle);
  /// No more triangles.
  void rank();

  /// After rank(): the place of the component that `point` is of, and their number and sizes.
  std::uint32_t rank_of(std::uint64_t point);
  std::uint64_t count() const { return sizes_.size(); }
  /// Points of the component of that rank.
  std::uint64_t size(std::uint64_t rank) const { return sizes_[rank]; }

 private:
  std::uint32_t root(std::uint32_t point);

  // A root holds kRoot and its size, later its rank; others hold a point nearer to the root.
  std::vector<std::uint32_t> links_;
  std::vector<std::uint32_t> sizes_;
};

}  // namespace stream_recon
