// The certificate of an infinite cell: no point of the cloud, not yet in the window, lies beyond
// its hull facet, nor in the facet's plane inside its circumcircle.
//
// Guarantees, thread rule: as CertificateSearch. Memory: none to speak of.
// Cost: about 10 ns a node; points in the plane of a flat side of the hull cost an exact test each.
#pragma once

#include <cstdint>
#include <optional>

#include "engine/windows/index_reader.h"
#include "engine/windows/present_points.h"
#include "spatial/delaunay.h"
#include "spatial/node_bounds.h"

namespace stream_recon {

class HalfSpaceSearch {
 public:
  HalfSpaceSearch(const CloudIndex& index, IndexReader& reader) : index_(index), reader_(reader) {}

  /// The leaf of the conflict farthest beyond the plane. \throw IoError
  std::optional<index_layout::LeafNumber> search(const Delaunay& delaunay,
                                                 const PresentPoints& present, CellId cell);

  /// Nodes looked at so far.
  std::uint64_t node_visits() const { return node_visits_; }

 private:
  bool may_reach(const NodeBounds& bounds, const index_layout::LeafRange& leaves);
  void descend_top(std::size_t level, std::uint64_t node);
  void descend_page(std::uint64_t page, std::uint32_t node);
  void search_leaf(index_layout::LeafNumber leaf);

  const CloudIndex& index_;
  IndexReader& reader_;
  const Delaunay* delaunay_ = nullptr;
  const PresentPoints* present_ = nullptr;
  CellId cell_ = 0;
  Point3 corner_;           ///< of the facet, scaled
  Point3 corner_relative_;  ///< to the origin of the index
  Point3 normal_;           ///< outward
  double normal_length_ = 0;
  double normal_error_ = 0;  ///< of the height of a point, for each unit of its distance
  double best_ = 0;          ///< height of the best conflict so far
  std::optional<index_layout::LeafNumber> conflict_;
  std::uint64_t node_visits_ = 0;
};

}  // namespace stream_recon
