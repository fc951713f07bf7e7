// Asks the index whether cells of a window are final: is there a point of the cloud, not yet in the
// window, in conflict with them?
//
// Guarantees: exact. A cell for which nothing is found is a cell of the Delaunay tetrahedralization
// of the whole cloud; a leaf that is named has a point in conflict, decided by the exact
// predicates.
// Thread rule: one window's. Memory: 20 KB a level of the index, about 300 KB.
// Cost: cells go through the index in packets of 512 that share each node's load; about 2 ns a cell
// and node.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "engine/windows/half_space_search.h"
#include "engine/windows/index_reader.h"
#include "engine/windows/present_points.h"
#include "spatial/ball_list.h"
#include "spatial/ball_points.h"
#include "spatial/circumball.h"
#include "spatial/delaunay.h"

namespace stream_recon {

/// What the search did, for the report.
struct SearchCounts {
  std::uint64_t queries = 0;
  std::uint64_t node_visits = 0;  ///< tests of a cell against a node

  void add(const SearchCounts& other) {
    queries += other.queries;
    node_visits += other.node_visits;
  }
};

class CertificateSearch {
 public:
  static constexpr std::size_t kMostCells = BallList::kMost;
  static constexpr index_layout::LeafNumber kFinal =
      std::numeric_limits<index_layout::LeafNumber>::max();

  CertificateSearch(const CloudIndex& index, IndexReader& reader);

  /// For each cell kFinal, or the leaf of a point in conflict with it: one deep inside.
  /// \pre At most kMostCells live cells. \throw IoError
  void search(const Delaunay& delaunay, const PresentPoints& present, std::span<const CellId> cells,
              std::span<index_layout::LeafNumber> conflicts);

  /// Since the last call.
  SearchCounts take_counts() { return std::exchange(counts_, {}); }

 private:
  struct Query {
    CellId cell;
    Circumball ball;
    double squared;  ///< radius of the search, shrinks as conflicts are found
    double best;     ///< power of the best conflict so far, 0 before the first
    index_layout::LeafNumber conflict;
  };

  void add_query(CellId cell);
  void descend_top(std::size_t level, std::uint64_t node, std::size_t depth);
  void descend_page(std::uint64_t page, std::uint32_t node, std::size_t depth);
  bool narrow(const NodeBounds& bounds, const index_layout::LeafRange& leaves, std::size_t depth);
  void search_leaf(index_layout::LeafNumber leaf, const BallList& balls);
  void look_closer(Query& query, index_layout::LeafNumber leaf, const PointPage& page);
  void refresh(std::size_t depth);

  const CloudIndex& index_;
  IndexReader& reader_;
  HalfSpaceSearch half_spaces_;
  const Delaunay* delaunay_ = nullptr;
  const PresentPoints* present_ = nullptr;
  std::vector<Query> queries_;
  std::vector<std::unique_ptr<BallList>> lists_;  ///< by depth
  std::uint64_t conflicts_found_ = 0;
  std::vector<std::uint64_t> refreshed_;  ///< conflicts_found_ when the list was last right
  PointPowers powers_;
  SearchCounts counts_;
};

}  // namespace stream_recon
