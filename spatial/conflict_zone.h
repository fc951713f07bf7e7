// One insertion of the Delaunay kernel: finds the cells whose circumsphere holds the point, and
// replaces them by cells from their boundary to the point (Bowyer 1981, Watson 1981).
//
// Invariant: before and after, the cells are the Delaunay structure of the points inserted.
// Thread rule: one writer. Cost: four in-sphere tests at a time; about 50 tests and 28 new cells a
// point of a random cloud.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "spatial/cell_array.h"
#include "spatial/edge_links.h"
#include "spatial/point.h"
#include "spatial/predicates.h"
#include "spatial/sphere_batch.h"

namespace stream_recon::detail {

class ConflictZone {
 public:
  ConflictZone() : test_spheres_(select_sphere_batch_test()) {}

  struct Request {
    const Point3* points;      ///< by vertex
    std::uint32_t vertex;      ///< the one to insert
    std::uint32_t first_cell;  ///< a cell in conflict with it
    std::size_t most_cells;    ///< limit of cell slots
  };

  /// A cell at the new vertex; nothing if the limit is reached: the cells are then unusable.
  bool insert(CellArray& cells, const Predicates& predicates, const Request& request,
              std::uint32_t& new_cell);

  void reserve_vertices(std::size_t count) { edge_links_.reserve_vertices(count); }
  std::size_t bytes() const;

 private:
  bool is_in_conflict(const Cell& cell, const Request& request, const Predicates& predicates) const;
  void add_to_zone(CellArray& cells, std::uint32_t cell, std::uint32_t entered_by);
  void build_on(CellArray& cells, std::uint32_t facet, std::uint32_t vertex);

  SphereBatchTest test_spheres_;
  EdgeLinks edge_links_;
  std::vector<std::uint32_t> zone_;     // the cells in conflict
  std::vector<std::uint32_t> pending_;  // facets of them to cross
  std::vector<std::uint32_t> built_;    // facet opposite the point, of every new cell
};

}  // namespace stream_recon::detail
