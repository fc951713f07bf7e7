// Asks the index whether cells of a window are final: is there a point of the cloud, not yet in the
// window, in conflict with them?
//
// Guarantees: exact. A cell for which nothing is found among all points is a cell of the Delaunay
// tetrahedralization of the whole cloud; a leaf that is named has a point in conflict, decided by
// the exact predicates. Thread rule: one window's. Memory: 12 KB a level of the index, about 250
// KB. Cost: cells go through the index in packets of 512 that share each node's load; about 1 ns a
// cell and node.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "engine/windows/half_space.h"
#include "engine/windows/index_reader.h"
#include "engine/windows/present_points.h"
#include "spatial/ball_list.h"
#include "spatial/ball_points.h"
#include "spatial/circumball.h"
#include "spatial/delaunay.h"
#include "spatial/sphere_cut.h"

namespace stream_recon {

/// What the search did, for the report.
struct SearchCounts {
  std::uint64_t queries = 0;
  std::uint64_t node_visits = 0;  ///< tests of a cell against a node
  std::uint64_t exact_tests = 0;  ///< points that doubles could not tell

  void add(const SearchCounts& other) {
    queries += other.queries;
    node_visits += other.node_visits;
    exact_tests += other.exact_tests;
  }
};

class CertificateSearch {
 public:
  static constexpr std::size_t kMostCells = BallList::kMost;
  static constexpr index_layout::LeafNumber kFinal =
      std::numeric_limits<index_layout::LeafNumber>::max();

  /// Held by a search, bytes.
  static std::uint64_t memory(const CloudIndex& index);

  CertificateSearch(const CloudIndex& index, IndexReader& reader);

  /// Among which points conflicts are looked for: those not present, from a leaf on.
  struct Scope {
    const PresentPoints& present;
    index_layout::LeafNumber first_leaf;
  };

  /// For each cell kFinal, or the leaf of a point in conflict with it: one deep inside.
  /// \pre At most kMostCells live cells. \throw IoError
  void search(const Delaunay& delaunay, const Scope& scope, std::span<const CellId> cells,
              std::span<index_layout::LeafNumber> conflicts);

  /// Since the last call.
  SearchCounts take_counts() { return std::exchange(counts_, {}); }

 private:
  /// What is empty if a cell is final.
  struct BallQuery {
    std::uint32_t place;  ///< of the cell among those asked about
    CellId cell;
    Circumball ball;
    Point3 centre;                        ///< relative to the origin of the index
    double squared;                       ///< radius of the search, shrinks as conflicts are found
    double best;                          ///< power of the best conflict so far, 0 before the first
    std::uint32_t sphere = Shell::kNone;  ///< of the cut
    SphereCut cut{};
  };
  struct HalfSpaceQuery {
    std::uint32_t place;
    CellId cell;
    HalfSpace half_space;
    double best;  ///< height of the best conflict so far
  };
  struct Leaf {
    index_layout::LeafNumber number;
    const PointPage& page;
    std::size_t offset;  ///< of its first point in the page
    std::uint32_t sphere = Shell::kNone;
    LeafHeights heights{};  ///< over the sphere

    void set_heights(std::uint32_t number_of, const Sphere& of);
    PointColumns columns() const { return {&page.x[offset], &page.y[offset], &page.z[offset]}; }
  };

  void add_query(CellId cell, std::uint32_t place);
  Region region(std::uint32_t id, const Shell& shell);
  std::optional<Region> cut_region(BallQuery& query, const Shell& shell);
  std::array<Point3, 4> scaled_corners(CellId cell) const;
  void descend_top(std::size_t level, std::uint64_t node, std::size_t depth);
  void enter_page(std::uint64_t page, std::size_t depth);
  void descend_page(std::uint64_t page, std::uint32_t node, std::size_t depth);
  bool narrow(const NodeBounds& bounds, const index_layout::LeafRange& leaves, std::size_t depth);
  void search_leaf(index_layout::LeafNumber leaf, const BallList& balls);
  void search_leaf(Leaf& leaf, BallQuery& query);
  void search_leaf(const Leaf& leaf, HalfSpaceQuery& query);

  const CloudIndex& index_;
  IndexReader& reader_;
  const Delaunay* delaunay_ = nullptr;
  const PresentPoints* present_ = nullptr;
  index_layout::LeafNumber first_leaf_ = 0;
  std::span<index_layout::LeafNumber> conflicts_;
  std::vector<BallQuery> balls_;
  std::vector<HalfSpaceQuery> half_spaces_;
  std::vector<std::unique_ptr<BallList>> lists_;  ///< by depth
  ListFrame top_frame_;
  ListFrame frame_;  ///< of the lists at work
  const NodePage* nodes_ = nullptr;
  PointPowers powers_;
  SearchCounts counts_;
};

}  // namespace stream_recon
