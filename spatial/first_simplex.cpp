#include "spatial/first_simplex.h"

#include <algorithm>
#include <utility>

#include "spatial/site.h"

namespace stream_recon::detail {

template <class Site>
FirstSimplex find_first_simplex(std::span<const Site> sites, std::uint32_t first_vertex,
                                const Predicates& predicates) {
  FirstSimplex simplex;
  std::array<const Point3*, 4> corner{};
  for (std::size_t i = 0; i < sites.size() && simplex.dimension < 3; ++i) {
    corner[simplex.dimension + 1] = &position(sites[i]);
    const auto& [a, b, c, d] = corner;
    if (simplex.dimension == 0 && *a == *b) continue;
    if (simplex.dimension == 1 && predicates.coplanar_orientation(*a, *b, *c) == 0) continue;
    if (simplex.dimension == 2 && predicates.orient3d(*a, *b, *c, *d) == 0) continue;
    simplex.vertices[++simplex.dimension] = first_vertex + static_cast<std::uint32_t>(i);
  }
  if (simplex.dimension == 3 &&
      predicates.orient3d(*corner[0], *corner[1], *corner[2], *corner[3]) < 0) {
    std::swap(simplex.vertices[0], simplex.vertices[1]);
  }
  return simplex;
}

template FirstSimplex find_first_simplex(std::span<const Point3>, std::uint32_t, const Predicates&);
template FirstSimplex find_first_simplex(std::span<const WeightedPoint3>, std::uint32_t,
                                         const Predicates&);

void make_first_cells(CellArray& cells, const FirstSimplex& simplex) {
  cells.make_room(5, CellArray::kMostCells);
  for (int i = 0; i < 5; ++i) cells.allocate();
  const auto position = [](std::uint8_t facet, std::uint8_t vertex) {
    const auto* corner = kFacet[facet];
    return static_cast<std::uint32_t>(std::find(corner, corner + 3, vertex) - corner);
  };
  for (std::uint8_t i = 0; i < 4; ++i) {
    cells[0].vertex[i] = simplex.vertices[i];
    cells[0].link[i] = facet_link(1 + i, 3);
    Cell& outer = cells[1 + i];
    for (int k = 0; k < 3; ++k) {
      const std::uint8_t opposite = kFacet[i][k];
      outer.vertex[k] = simplex.vertices[opposite];
      outer.link[k] = facet_link(1 + opposite, position(opposite, i));
    }
    outer.vertex[3] = 0;
    outer.link[3] = facet_link(0, i);
  }
}

}  // namespace stream_recon::detail
