// The exact 3D Delaunay tetrahedralization of a set of points, built incrementally in core.
//
// Guarantees: after insert() returns kDone, the finite cells are exactly the Delaunay tetrahedra of
// all points inserted so far, cospherical ties decided by the lexicographic symbolic perturbation
// of Devillers and Teillaud (2011): no flat cells, and the result does not depend on the order of
// insertion. Every facet of the convex hull carries one infinite cell.
// Vertex ids are positions in the order of the inserted points (0, 1, 2, ...).
// Memory: 32 bytes a cell, 25 bytes a point (on surfaces and volumes 6 to 8.5 cells a point).
// Thread rule: one writer; const access from many.
// Source: Bowyer 1981, Watson 1981; rounds of Amenta, Choi, Rote 2003.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <span>

#include "spatial/coordinate_range.h"
#include "spatial/point.h"

namespace stream_recon {

using VertexId = std::uint32_t;
using CellId = std::uint32_t;

template <class Site>
class BasicCellView;
using CellView = BasicCellView<Point3>;

class Delaunay {
 public:
  /// The vertex at infinity.
  static constexpr VertexId kInfinite = (VertexId{1} << 30) - 1;

  enum class Outcome {
    kDone,
    kFlat,      ///< fewer than four affinely independent points so far: no cells yet
    kOutgrown,  ///< max_bytes reached: the structure is unusable, split the work
    kBadRange,  ///< coordinates too far apart in magnitude for exact arithmetic
                ///< (docs/algorithms/predicates.md)
  };

  struct Options {
    /// Largest memory of cells and points together, bytes.
    std::size_t max_bytes = std::numeric_limits<std::size_t>::max();
    /// Holds all points that will be inserted or asked about, if more than the inserted ones are.
    CoordinateRange range;
  };

  explicit Delaunay(const Options& options);
  Delaunay();
  ~Delaunay();
  Delaunay(Delaunay&&) noexcept;
  Delaunay& operator=(Delaunay&&) noexcept;

  /// Changes Options::max_bytes for what is inserted from now on.
  void set_max_bytes(std::size_t max_bytes);

  /// Adds points. They should come in a spatially coherent order (Hilbert); the randomness that
  /// the cost needs is made inside.
  /// \pre All finite, distinct from each other and from those before.
  [[nodiscard]] Outcome insert(std::span<const Point3> points);

  /// Whether a point, inserted, would destroy a live cell: exact, ties decided as in insert().
  /// \pre The point is not a vertex, and lies in the range of the options or of the vertices.
  bool in_conflict(CellId c, const Point3& p) const;

  /// Affine dimension of the points so far, -1 for none.
  int dimension() const;
  std::size_t vertex_count() const;
  Point3 point(VertexId v) const;

  /// Cells are numbered 0 .. cell_slots() - 1; some slots are free.
  CellId cell_slots() const;
  bool is_live(CellId c) const;
  bool is_infinite(CellId c) const;
  /// Positively oriented (the fourth vertex sees the first three counterclockwise from outside:
  /// orient3d > 0). kInfinite, where present, is the fourth.
  std::array<VertexId, 4> vertices(CellId c) const;
  /// The cell across the facet opposite vertex i.
  CellId neighbor(CellId c, int i) const;
  /// Which facet of neighbor(c, i) that is.
  int mirror_index(CellId c, int i) const;

  /// All of them at once, for loops (spatial/cell_view.h).
  CellView view() const;

  std::size_t finite_cell_count() const;
  /// Bytes of memory in use, the peak of this object.
  std::size_t bytes() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace stream_recon
