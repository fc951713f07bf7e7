// The evidence that one window sees, strongest first, as edges between its cells.
//
// Nodes are cell slots; one more stands for all infinite cells. Guarantees: weights and ties are
// functions of the cloud alone, whatever the window. Thread rule: one thread. Memory: memory().
// Cost: about 150 ns a facet.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/labels/evidence_records.h"
#include "engine/labels/signed_forest.h"
#include "engine/poles/star_poles.h"
#include "engine/surface/ranked_facet.h"
#include "engine/windows/final_window.h"
#include "spatial/cell_view.h"
#include "spatial/facet_balls.h"

namespace stream_recon {

class WindowEvidence {
 public:
  /// \param spacing of every vertex, units of the input; outlives the evidence
  WindowEvidence(const FinalWindow& window, std::span<const float> spacing);

  /// For so many cells with an owned vertex, and owned points.
  static constexpr std::uint64_t memory(std::uint64_t cells, std::uint64_t owned) {
    return most_edges(cells, owned) * sizeof(Entry) + StarPoles::memory(owned);
  }

  /// The forest of all edges. \return what is left of them for other windows, in order; no more
  /// than there are border nodes. Called once.
  std::vector<EvidenceEdge> contract(SignedForest& forest, std::uint64_t border_nodes);

  std::uint32_t infinite_node() const { return cells_.slots(); }
  std::uint32_t node(CellId cell) const {
    return cells_.is_infinite(cell) ? infinite_node() : cell;
  }
  const StarPoles& poles() const { return poles_; }

  /// A facet with the balls beside it: the first is that of `cell`. \pre the cell is finite
  FacetBalls balls(const RankedFacet& facet, CellId cell, int side) const;
  double spacing(const RankedFacet& facet) const;

 private:
  /// Names of facets are 4 cell + side, of a pole pair the number of the sample from the last
  /// downwards, so that they do not meet.
  struct Entry {
    std::uint32_t key;  ///< the larger, the earlier
    std::uint32_t name;
  };

  /// Both cells of a facet have an owned vertex.
  static constexpr std::uint64_t most_edges(std::uint64_t cells, std::uint64_t owned) {
    return 2 * cells + owned;
  }
  std::uint64_t count_cells() const;
  void add_facets();
  void add_poles();
  void sort();
  bool is_pole_pair(std::uint32_t name) const { return name >= first_pair_name_; }
  VertexId sample_of(std::uint32_t name) const { return ~name; }
  std::array<std::uint32_t, 3> tie(std::uint32_t name) const;
  /// Without its tie.
  EvidenceEdge edge(const Entry& entry) const;

  const FinalWindow& window_;
  const CellView cells_;
  std::span<const float> spacing_;
  StarPoles poles_;
  std::uint32_t first_pair_name_;
  std::vector<Entry> entries_;
};

}  // namespace stream_recon
