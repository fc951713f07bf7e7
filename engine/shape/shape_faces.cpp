#include "engine/shape/shape_faces.h"

#include <algorithm>
#include <array>
#include <utility>

#include "spatial/cell_view.h"

namespace stream_recon {
namespace {

/// Corners of a cell: those of an edge, then the other two.
constexpr std::array<std::array<int, 4>, 6> kEdges{
    {{0, 1, 2, 3}, {0, 2, 1, 3}, {0, 3, 1, 2}, {1, 2, 0, 3}, {1, 3, 0, 2}, {2, 3, 0, 1}}};

class ShapeExtraction {
 public:
  explicit ShapeExtraction(const PowerWindow& power)
      : poles_(power.poles()), cells_(power.triangulation().view()) {
    const RegularTriangulation& triangulation = power.triangulation();
    for (VertexId v = 0; v < poles_.owned_count(); ++v) {
      result_.counts.vertices += triangulation.is_hidden(v) ? 0 : 1;
    }
  }

  ShapeFaces run() {
    for (CellId cell = 0; cell < cells_.slots(); ++cell) {
      if (!cells_.is_live(cell)) continue;
      const auto v = cells_.vertices(cell);
      if (std::min(std::min(v[0], v[1]), std::min(v[2], v[3])) >= poles_.owned_count()) continue;
      if (is_emitted(v)) ++result_.counts.tetrahedra;
      for (int side = 0; side < 4; ++side) add_triangle(cell, side);
      for (const auto& edge : kEdges) add_edge(cell, edge);
    }
    std::sort(result_.faces.begin(), result_.faces.end());
    return std::move(result_);
  }

 private:
  bool is_inside(VertexId pole) const {
    return pole != RegularTriangulation::kInfinite && poles_[pole].is_inside;
  }

  /// All are inside, and the pole of lowest number is owned.
  template <std::size_t n>
  bool is_emitted(const std::array<VertexId, n>& poles) const {
    VertexId lowest = poles[0];
    for (const VertexId pole : poles) {
      if (!is_inside(pole)) return false;
      if (poles_[pole].number < poles_[lowest].number) lowest = pole;
    }
    return lowest < poles_.owned_count();
  }

  void add_triangle(CellId cell, int side) {
    if (cells_.neighbor(cell, side) < cell) return;  // has it, too
    const auto v = cells_.facet(cell, side);
    if (!is_emitted(v)) return;
    ++result_.counts.triangles;
    ShapeFace face{{poles_[v[0]].number, poles_[v[1]].number, poles_[v[2]].number}};
    std::sort(face.poles.begin(), face.poles.end());
    result_.faces.push_back(face);
  }

  void add_edge(CellId cell, const std::array<int, 4>& at) {
    const std::array<VertexId, 2> ends{cells_.vertex(cell, at[0]), cells_.vertex(cell, at[1])};
    if (!is_emitted(ends) || !is_lowest_around(cell, at)) return;
    ++result_.counts.edges;
    if (has_triangle_) return;
    ++result_.counts.bare_edges;
    const auto [low, high] = std::minmax(poles_[ends[0]].number, poles_[ends[1]].number);
    result_.faces.push_back({{low, high, kNoPole}});
  }

  /// Goes around the edge, and sees whether one of the poles around it is inside.
  bool is_lowest_around(CellId first, const std::array<int, 4>& at) {
    if (cells_.neighbor(first, at[2]) < first || cells_.neighbor(first, at[3]) < first)
      return false;
    has_triangle_ = false;
    CellId cell = first;
    VertexId kept = cells_.vertex(first, at[2]);
    int crossed = at[3];
    do {
      has_triangle_ = has_triangle_ || is_inside(kept);
      const CellId next = cells_.neighbor(cell, crossed);
      if (next < first) return false;
      const int entered = cells_.mirror_index(cell, crossed);
      crossed = corner(next, kept);
      kept = cells_.vertex(next, entered);
      cell = next;
    } while (cell != first);
    return true;
  }

  int corner(CellId cell, VertexId v) const {
    for (int i = 0; i < 3; ++i) {
      if (cells_.vertex(cell, i) == v) return i;
    }
    return 3;
  }

  const SamplePoles& poles_;
  const WeightedCellView cells_;
  bool has_triangle_ = false;  ///< of the edge gone around last
  ShapeFaces result_;
};

}  // namespace

void ShapeCounts::add(const ShapeCounts& other) {
  vertices += other.vertices;
  edges += other.edges;
  bare_edges += other.bare_edges;
  triangles += other.triangles;
  tetrahedra += other.tetrahedra;
}

ShapeFaces shape_faces(const PowerWindow& power) {
  return ShapeExtraction(power).run();
}

// Up to sixteen triangles for each owned pole, in a list that grows by doubling.
std::uint64_t shape_faces_memory(const PowerWindow& power) {
  return 32 * sizeof(ShapeFace) * std::uint64_t{power.poles().owned_count()};
}

}  // namespace stream_recon
