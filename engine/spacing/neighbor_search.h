// The nearest neighbours of every point of a leaf of the index, among all points of the cloud.
//
// Guarantees: exact. The neighbours of a point are the least others by (squared distance, rank),
// with squared distances as spatial/nearest_list.h computes them: a function of the cloud alone.
// Thread rule: one thread's. Memory: kMemory, for the pages it pins. Cost: about 1 us a point; the
// sixteen points of a leaf go through the index together.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "engine/spacing/pinned_pages.h"
#include "engine/windows/index_reader.h"
#include "spatial/nearest_list.h"

namespace stream_recon {

class NeighborSearch {
 public:
  static constexpr std::size_t kMost = NearestList::kMost - 1;  ///< neighbours of a point
  static constexpr std::uint64_t kMemory = PinnedPages::kMemory + (std::uint64_t{64} << 10);

  NeighborSearch(const CloudIndex& index, IndexReader& reader) : index_(index), pages_(reader) {}

  /// \throw IoError
  void search(index_layout::LeafNumber leaf);

  /// Of the leaf searched last.
  std::size_t point_count() const { return count_; }

  /// From point i of the leaf to its neighbours, scaled as the index is, the nearest first; as many
  /// as there are, at most kMost. Valid until the next call. \throw IoError
  std::span<const Point3> vectors(std::size_t i);

 private:
  using LeafNumber = index_layout::LeafNumber;

  /// The points of the leaf, relative to the origin of the index.
  struct Queries {
    std::array<double, index_layout::kLeafPoints> x, y, z;
  };

  void descend_top(std::size_t level, std::uint64_t node);
  void descend_page(std::uint64_t page, std::uint32_t node);
  void load(LeafNumber leaf);
  bool search_within(double squared_distance);
  bool reaches(const NodeBounds& bounds);
  void visit_leaf(LeafNumber leaf);
  double squared_gap(const NodeBounds& bounds) const;

  const CloudIndex& index_;
  PinnedPages pages_;
  LeafNumber leaf_ = 0;
  std::size_t count_ = 0;
  NodeBounds box_{};  ///< of the leaf
  Queries relative_;
  /// Squared distances within which something is looked for: those of the lists, negative for
  /// points that are done; and the largest.
  std::array<double, index_layout::kLeafPoints> bounds_{};
  double bound_ = 0;
  SquaredGaps gaps_{};   ///< to the node looked at last
  double farthest_ = 0;  ///< of the neighbours asked for since the last search, squared
  std::array<NearestList, index_layout::kLeafPoints> lists_;
  std::array<Point3, kMost> vectors_;
};

}  // namespace stream_recon
