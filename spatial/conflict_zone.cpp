#include "spatial/conflict_zone.h"

#include <bit>

namespace stream_recon::detail {
bool is_in_conflict(const Cell& cell, const Point3* points, const Point3& p,
                    const Predicates& predicates) {
  const Point3& a = points[vertex_of(cell, 0)];
  const Point3& b = points[cell.vertex[1]];
  const Point3& c = points[cell.vertex[2]];
  if (!is_infinite(cell)) {
    return predicates.in_sphere_perturbed(a, b, c, points[cell.vertex[3]], p) > 0;
  }
  const int side = predicates.orient3d(a, b, c, p);
  return side != 0 ? side > 0 : predicates.in_circle_perturbed(a, b, c, p) > 0;
}

namespace {

bool decide_tie(const Cell& cell, const ConflictZone::Request& request,
                const Predicates& predicates) {
  const Point3* points = request.points;
  return predicates.in_sphere_tie(points[cell.vertex[0]], points[cell.vertex[1]],
                                  points[cell.vertex[2]], points[cell.vertex[3]],
                                  points[request.vertex]) > 0;
}

}  // namespace

// Lists a cell, if it counts, and its facets but the one it was entered by. Written in any case and
// then counted or not: a branch here would be mispredicted every other time.
inline void ConflictZone::add(CellArray& cells, std::uint32_t cell, std::uint32_t entered_by,
                              bool counts) {
  Cell& entered = cells[cell];
  entered.vertex[0] |= counts ? kDead : 0;
  *zone_.end() = cell;
  zone_.grow(counts ? 1 : 0);
  SharedFacet* const facet = pending_.end();
  for (int k = 0; k < 3; ++k) {
    const std::uint32_t i = kFacet[entered_by][k];
    facet[k] = {facet_link(cell, i), entered.link[i]};
    __builtin_prefetch(&cells[cell_of(entered.link[i])]);
  }
  pending_.grow(counts ? 3 : 0);
}

// The next four facets with a cell beyond that is not in the zone; fewer only at the end.
inline ConflictZone::Batch ConflictZone::next_batch(const CellArray& cells) {
  Batch batch;
  const SharedFacet* const pending = pending_.begin();
  const std::size_t end = pending_.size();
  while (batch.count < 4 && next_ < end) {
    const SharedFacet facet = pending[next_++];
    batch.facet[batch.count] = facet;
    batch.count += is_dead(cells[cell_of(facet.outer)]) ? 0 : 1;
  }
  return batch;
}

inline void ConflictZone::test(Batch& batch, const CellArray& cells, const Predicates& predicates,
                               const Request& request) const {
  const PaddedPoint query{request.points[request.vertex]};
  std::array<const Cell*, 4> beyond;
  unsigned infinite = 0;
  for (unsigned i = 0; i < 4; ++i) {
    beyond[i] = &cells[cell_of(batch.facet[i < batch.count ? i : 0].outer)];
    infinite |= static_cast<unsigned>(is_infinite(*beyond[i])) << i;
  }
  const SphereBatch known =
      test_spheres_(beyond, request.points, query, predicates.in_sphere_reach());
  batch.in_conflict = known.inside & ~infinite;
  unsigned open = ((1U << batch.count) - 1) & (infinite | ~(known.inside | known.outside));
  for (; open != 0; open &= open - 1) {
    const unsigned lane = static_cast<unsigned>(std::countr_zero(open));
    const bool is_tie = ((known.cospherical & ~infinite) >> lane & 1) != 0;
    const bool inside =
        is_tie ? decide_tie(*beyond[lane], request, predicates)
               : is_in_conflict(*beyond[lane], request.points, query.point, predicates);
    batch.in_conflict |= static_cast<unsigned>(inside) << lane;
  }
}

inline void ConflictZone::sort_out(const Batch& batch, CellArray& cells) {
  pending_.make_room(12 + 3);
  boundary_.make_room(4 + 1);
  zone_.make_room(4 + 1);
  for (unsigned i = 0; i < batch.count; ++i) {
    const SharedFacet facet = batch.facet[i];
    const std::uint32_t beyond = cell_of(facet.outer);
    // An earlier facet of the batch may have led to the same cell.
    const unsigned is_new = is_dead(cells[beyond]) ? 0 : 1;
    const unsigned in_conflict = batch.in_conflict >> i & 1;
    *boundary_.end() = facet;
    boundary_.grow(is_new & ~in_conflict);
    add(cells, beyond, facet_of(facet.outer), (is_new & in_conflict) != 0);
  }
}

void ConflictZone::find(CellArray& cells, const Predicates& predicates, const Request& request) {
  zone_.clear();
  pending_.clear();
  boundary_.clear();
  pending_.make_room(4);
  zone_.make_room(1);
  next_ = 0;
  add(cells, request.first_cell, 3, true);
  *pending_.end() = {facet_link(request.first_cell, 3), cells[request.first_cell].link[3]};
  pending_.grow(1);
  for (;;) {
    Batch batch = next_batch(cells);
    if (batch.count == 0) return;
    test(batch, cells, predicates, request);
    sort_out(batch, cells);
  }
}

}  // namespace stream_recon::detail
