// Which tetrahedra of a window of samples are poles, and which of those are in its power diagram.
//
// Guarantees: poles are numbered as the vertices of the power diagram are, owned ones first; none
// is there twice. Thread rule: one window's. Memory: bytes(): 28 bytes a pole, 32 more until it is
// taken, 1 a tetrahedron. Cost: one look-up of a name (pole_finder.h) a final tetrahedron.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "engine/power/pole_finder.h"
#include "engine/power/sample_choice.h"
#include "engine/windows/certified_window.h"
#include "spatial/regular_triangulation.h"

namespace stream_recon {

class SamplePoles {
 public:
  static constexpr CellId kNoCell = static_cast<CellId>(-1);

  struct Entry {
    PoleNumber number;  ///< in the store
    CellId cell;        ///< of the samples; kNoCell where the window may not have it
    NodeKey name;       ///< the ranks of its tetrahedron
    bool is_inside;
  };

  /// \pre The window has been built with whole stars. Both outlive the object.
  SamplePoles(const CertifiedWindow& samples, PoleFinder& finder)
      : samples_(samples), finder_(finder) {}

  /// All poles inside the body whose lowest sample is in the range, and that touch a sample of the
  /// choice, if there is one. \pre Called first, once. \throw IoError
  void add_owned(const OwnedRange& owned, const SampleChoice* choice);
  /// These as well, without cells. \pre Ascending. Called after add_owned(), once.
  void add_some(std::span<const NumberedPole> some);
  /// Adds the final cell's pole, if it is one and not there yet. \throw IoError
  void add_missing(CellId cell);

  /// What is known of a final cell: whether it is a pole, and then whether that was added, and has
  /// been taken for the diagram. kUnknown is never returned.
  enum class State : std::uint8_t { kUnknown, kNotAPole, kMissing, kAdded, kInserted };
  /// \throw IoError
  State state(CellId cell);
  /// \pre The cell is a pole. \throw IoError
  WeightedPoint3 site(CellId cell) { return site_of(finder_.pole(finder_.find(name_of(cell)))); }

  /// Those added since the last call, in the order of the new vertices of the power diagram.
  std::vector<WeightedPoint3> take_added();

  VertexId count() const { return static_cast<VertexId>(entries_.size()); }
  VertexId owned_count() const { return owned_count_; }
  bool has_added() const { return !added_.empty(); }
  const Entry& operator[](VertexId v) const { return entries_[v]; }
  void prefetch(VertexId v) const { __builtin_prefetch(&entries_[v]); }
  /// The sample that all of these touch, of several that of the lowest rank, as a vertex of the
  /// window; nothing if there is none, or none of them has a cell.
  std::optional<VertexId> common_sample(std::span<const VertexId> poles) const;

  std::uint64_t bytes() const;

 private:
  NodeKey name_of(CellId cell) const;
  void find_cells_of_owned(const OwnedRange& owned);
  void add(PoleNumber number, const Pole& pole, CellId cell);

  const CertifiedWindow& samples_;
  PoleFinder& finder_;
  std::vector<Entry> entries_;
  std::vector<WeightedPoint3> added_;
  std::vector<State> states_;      ///< of cells
  std::vector<PoleNumber> loose_;  ///< of entries without a cell, ascending
  VertexId owned_count_ = 0;
};

}  // namespace stream_recon
