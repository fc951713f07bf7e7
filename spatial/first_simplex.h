// The start of an incremental Delaunay: four affinely independent points and their five cells.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "spatial/cell_array.h"
#include "spatial/point.h"
#include "spatial/predicates.h"

namespace stream_recon::detail {

struct FirstSimplex {
  int dimension = -1;                       ///< affine dimension of all points
  std::array<std::uint32_t, 4> vertices{};  ///< dimension + 1 of them, positively oriented for 3
};

/// Looks through the sites in order; weights do not matter. Vertex numbers count from
/// `first_vertex`. Linear in the sites.
template <class Site>
FirstSimplex find_first_simplex(std::span<const Site> sites, std::uint32_t first_vertex,
                                const Predicates& predicates);

/// Fills empty cells with the simplex (cell 0) and the infinite cells on its four facets.
/// \pre simplex.dimension == 3
void make_first_cells(CellArray& cells, const FirstSimplex& simplex);

}  // namespace stream_recon::detail
