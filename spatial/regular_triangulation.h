// The exact regular triangulation (weighted Delaunay) of points with weights, built incrementally
// in core: the Delaunay kernel with the power test in place of the in-sphere test.
//
// The power of a point x to a site (p, w) is |x - p|^2 - w; for a ball w is its squared radius.
// Guarantees: after insert() returns kDone, the finite cells are exactly those of the regular
// triangulation of all sites inserted so far: the sphere orthogonal to a cell's sites is closer
// than orthogonal to no other site, ties decided by the lexicographic symbolic perturbation of
// Devillers and Teillaud (2011). The result does not depend on the order of insertion. Every site
// is a vertex of cells or hidden; of sites at one place the heaviest can be a vertex, of equal ones
// the one inserted first.
// Vertex ids are positions in the order of the inserted sites (0, 1, 2, ...).
// Memory: 32 bytes a cell, 33 bytes a site and a bit.
// Thread rule: one writer; const access from many.
// Source: Edelsbrunner, Shah 1996 ("Incremental topological flipping works for regular
// triangulations"); docs/algorithms/weighted.md.
#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <span>

#include "spatial/delaunay.h"
#include "spatial/point.h"

namespace stream_recon {

using WeightedCellView = BasicCellView<WeightedPoint3>;

class RegularTriangulation {
 public:
  static constexpr VertexId kInfinite = Delaunay::kInfinite;

  /// kFlat: there are no cells yet, and nothing is hidden.
  using Outcome = Delaunay::Outcome;
  /// The range counts the weights as well.
  using Options = Delaunay::Options;

  explicit RegularTriangulation(const Options& options);
  RegularTriangulation();
  ~RegularTriangulation();
  RegularTriangulation(RegularTriangulation&&) noexcept;
  RegularTriangulation& operator=(RegularTriangulation&&) noexcept;

  /// Changes Options::max_bytes for what is inserted from now on.
  void set_max_bytes(std::size_t max_bytes);

  /// Adds sites. They should come in a spatially coherent order (Hilbert); the randomness that the
  /// cost needs is made inside. \pre All finite.
  [[nodiscard]] Outcome insert(std::span<const WeightedPoint3> sites);

  /// Whether a site, inserted, would destroy a live cell: exact, ties decided as in insert().
  /// \pre The site lies in the range of the options or of the vertices.
  bool in_conflict(CellId c, const WeightedPoint3& site) const;

  /// Affine dimension of the sites so far, -1 for none.
  int dimension() const;
  /// Vertices and hidden ones.
  std::size_t site_count() const;
  WeightedPoint3 site(VertexId v) const;

  /// Whether a site is a vertex of no cell; for good, whatever is inserted later.
  bool is_hidden(VertexId v) const;
  std::size_t hidden_count() const;

  /// As Delaunay's.
  CellId cell_slots() const;
  bool is_live(CellId c) const;
  bool is_infinite(CellId c) const;
  std::array<VertexId, 4> vertices(CellId c) const;
  CellId neighbor(CellId c, int i) const;
  int mirror_index(CellId c, int i) const;
  WeightedCellView view() const;

  std::size_t finite_cell_count() const;
  /// Bytes of memory in use, the peak of this object.
  std::size_t bytes() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace stream_recon
