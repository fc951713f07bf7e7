// The points nearest to a place, of a set of points in memory.
//
// Guarantees: exact, and the same answer for the same set: by ascending distance, of equal ones the
// lower index first; of several equally far ones that compete for the last place the tree's order
// decides. Thread rule: any number of threads may ask at once. Memory: 60 bytes a point; the points
// themselves must stay. Cost: n log n to build, about 1 us a question.
// Source: Muja, Lowe, Fast approximate nearest neighbors, 2009 (FLANN; its exact tree).
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "spatial/point.h"

namespace stream_recon {

struct Neighbor {
  std::uint32_t index = 0;
  double squared_distance = 0;

  friend bool operator==(const Neighbor&, const Neighbor&) = default;
  friend bool operator<(const Neighbor& a, const Neighbor& b) {
    if (a.squared_distance != b.squared_distance) return a.squared_distance < b.squared_distance;
    return a.index < b.index;
  }
};

class Neighbors {
 public:
  /// \pre the points are finite
  explicit Neighbors(std::span<const Point3> points);
  ~Neighbors();
  Neighbors(Neighbors&&) noexcept;
  Neighbors& operator=(Neighbors&&) noexcept;

  std::size_t count() const { return points_.size(); }

  /// \return min(count, number of points) of them
  std::vector<Neighbor> nearest(const Point3& place, std::size_t count) const;

 private:
  struct Tree;

  std::span<const Point3> points_;
  std::unique_ptr<Tree> tree_;  ///< none for few points
};

}  // namespace stream_recon
