// The evidence that one window sees, strongest first, as edges between its cells.
//
// Nodes are the finite cells with an owned vertex, numbered as StarBalls numbers them; one more
// stands for all infinite cells. Guarantees: weights and ties are functions of the cloud alone,
// whatever the window. Thread rule: one thread. Memory: memory(). Cost: about 100 ns a facet.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "engine/labels/evidence_records.h"
#include "engine/labels/signed_forest.h"
#include "engine/poles/ranked_cell.h"
#include "engine/poles/star_balls.h"
#include "engine/poles/star_poles.h"
#include "engine/windows/final_window.h"
#include "spatial/cell_view.h"

namespace stream_recon {

/// The spacing of a vertex that is no sample: smaller than that of any sample.
inline constexpr float kNoSample = std::numeric_limits<float>::min();

class WindowEvidence {
 public:
  /// \param spacing of every vertex, scaled as the balls are, or kNoSample; outlives the evidence,
  /// as
  ///        the window does
  WindowEvidence(const FinalWindow& window, std::span<const float> spacing, const StarBalls& balls);

  /// For so many cells with an owned vertex, and owned points; the balls not counted.
  static constexpr std::uint64_t memory(std::uint64_t cells, std::uint64_t owned) {
    return most_edges(cells, owned) * sizeof(Entry) + StarPoles::memory(owned);
  }

  /// Takes the edges into a forest. \return what is left of them for other windows, in order; no
  /// more than there are border nodes. Called once.
  std::vector<EvidenceEdge> contract(SignedForest& forest, std::uint64_t border_nodes);

  const StarPoles& poles() const { return poles_; }

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
  void add_facets(const StarBalls& balls);
  void add_facet(CellId cell, const RankedCell& ranked, int apex, const StarBalls& balls);
  void add_poles(const StarBalls& balls);
  void prefetch(std::uint32_t name) const {
    if (!is_pole_pair(name)) cells_.prefetch(name / 4);
  }
  void sort();
  void sort_equal(std::span<Entry> entries);
  bool is_pole_pair(std::uint32_t name) const { return name >= first_pair_name_; }
  VertexId sample_of(std::uint32_t name) const { return ~name; }
  std::array<std::uint32_t, 3> tie(std::uint32_t name) const;
  /// Without its tie.
  EvidenceEdge edge(const Entry& entry) const;

  const FinalWindow& window_;
  const CellView cells_;
  const NodeSet& nodes_;
  std::span<const float> spacing_;
  StarPoles poles_;
  std::uint32_t first_pair_name_;
  std::vector<Entry> entries_;
};

}  // namespace stream_recon
