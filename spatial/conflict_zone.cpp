#include "spatial/conflict_zone.h"

#include <array>

namespace stream_recon::detail {

// Whether the point is inside the circumsphere or, for an infinite cell, beyond the hull facet. In
// the plane of the facet the circumsphere shrinks to the facet's circumcircle.
bool ConflictZone::is_in_conflict(const Cell& cell, const Request& request,
                                  const Predicates& predicates) const {
  const Point3& p = request.points[request.vertex];
  const Point3& a = request.points[vertex_of(cell, 0)];
  const Point3& b = request.points[cell.vertex[1]];
  const Point3& c = request.points[cell.vertex[2]];
  if (!is_infinite(cell)) {
    return predicates.in_sphere_perturbed(a, b, c, request.points[cell.vertex[3]], p) > 0;
  }
  const int side = predicates.orient3d(a, b, c, p);
  return side != 0 ? side > 0 : predicates.in_circle_perturbed(a, b, c, p) > 0;
}

inline void ConflictZone::add_to_zone(CellArray& cells, std::uint32_t cell,
                                      std::uint32_t entered_by) {
  cells[cell].vertex[0] |= kDead;
  zone_.push_back(cell);
  for (std::uint32_t i = 0; i < 4; ++i) {
    if (i == entered_by) continue;
    pending_.push_back(facet_link(cell, i));
    __builtin_prefetch(&cells[cell_of(cells[cell].link[i])]);
  }
}

// The new cell takes the place of the old one at the facet; the vertex stands where the vertex
// opposite the facet stood, which keeps the orientation and infinity in the last place.
inline void ConflictZone::build_on(CellArray& cells, std::uint32_t facet, std::uint32_t vertex) {
  const std::uint32_t i = facet_of(facet);
  const std::uint32_t built = cells.allocate();
  const Cell& old = cells[cell_of(facet)];
  Cell& cell = cells[built];
  for (int k = 0; k < 4; ++k) cell.vertex[k] = old.vertex[k];
  cell.vertex[0] &= ~kDead;
  cell.vertex[i] = vertex;
  const std::uint32_t outer = old.link[i];
  cell.link[i] = outer;
  cells[cell_of(outer)].link[facet_of(outer)] = facet_link(built, i);
  built_.push_back(facet_link(built, i));
}

bool ConflictZone::insert(CellArray& cells, const Predicates& predicates, const Request& request,
                          std::uint32_t& new_cell) {
  const PaddedPoint query{request.points[request.vertex]};
  zone_.clear();
  pending_.clear();
  built_.clear();
  if (!cells.make_room(4, request.most_cells)) return false;
  add_to_zone(cells, request.first_cell, 4);
  std::size_t next = 0;
  for (;;) {
    // The next four facets with a cell behind them that is not in the zone.
    std::array<std::uint32_t, 4> facet;
    std::array<const Cell*, 4> beyond;
    unsigned count = 0;
    while (count < 4 && next < pending_.size()) {
      const std::uint32_t link = pending_[next++];
      const Cell& cell = cells[cell_of(cells[cell_of(link)].link[facet_of(link)])];
      if (is_dead(cell)) continue;
      facet[count] = link;
      beyond[count++] = &cell;
    }
    if (count == 0) break;
    for (unsigned i = count; i < 4; ++i) beyond[i] = beyond[0];
    const SphereBatch known =
        test_spheres_(beyond, request.points, query, predicates.in_sphere_reach());
    // Links of zone cells stay as they were, so indices remain good when the array moves.
    std::array<std::uint32_t, 4> link;
    for (unsigned i = 0; i < count; ++i) {
      link[i] = cells[cell_of(facet[i])].link[facet_of(facet[i])];
    }
    if (!cells.make_room(4, request.most_cells)) return false;
    for (unsigned i = 0; i < count; ++i) {
      const Cell& cell = cells[cell_of(link[i])];
      if (is_dead(cell)) continue;  // by an earlier lane
      bool in_conflict = (known.inside >> i & 1) != 0;
      if (is_infinite(cell) || ((known.inside | known.outside) >> i & 1) == 0) [[unlikely]] {
        if (!is_infinite(cell) && (known.cospherical >> i & 1) != 0) {
          in_conflict = predicates.in_sphere_tie(request.points[cell.vertex[0]],
                                                 request.points[cell.vertex[1]],
                                                 request.points[cell.vertex[2]],
                                                 request.points[cell.vertex[3]], query.point) > 0;
        } else {
          in_conflict = is_in_conflict(cell, request, predicates);
        }
      }
      if (in_conflict) {
        add_to_zone(cells, cell_of(link[i]), facet_of(link[i]));
      } else {
        build_on(cells, facet[i], request.vertex);
      }
    }
  }
  edge_links_.join(cells, built_);
  cells.release(zone_.data(), zone_.size());
  new_cell = cell_of(built_.back());
  return true;
}

std::size_t ConflictZone::bytes() const {
  return edge_links_.bytes() +
         (zone_.capacity() + pending_.capacity() + built_.capacity()) * sizeof(std::uint32_t);
}

}  // namespace stream_recon::detail
