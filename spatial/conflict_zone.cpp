#include "spatial/conflict_zone.h"

#include <bit>

namespace stream_recon::detail {

template <class Site>
bool is_in_conflict(const Cell& cell, const Site* sites, const Site& query,
                    const Predicates& predicates) {
  const CellSites<Site> corners(cell, sites);
  if (!is_infinite(cell)) return SiteTests<Site>::side(predicates, corners, query) > 0;
  const int side = predicates.orient3d(position(corners.a), position(corners.b),
                                       position(corners.c), position(query));
  return side != 0 ? side > 0 : SiteTests<Site>::side_in_plane(predicates, corners, query) > 0;
}

// Lists a cell, if it counts, and its facets but the one it was entered by. Written in any case and
// then counted or not: a branch here would be mispredicted every other time.
template <class Site>
inline void ConflictZone<Site>::add(CellArray& cells, std::uint32_t cell, std::uint32_t entered_by,
                                    bool counts) {
  Cell& entered = cells[cell];
  entered.vertex[0] |= counts ? kDead : 0;
  *lists_.cells.end() = cell;
  lists_.cells.grow(counts ? 1 : 0);
  SharedFacet* const facet = pending_.end();
  for (int k = 0; k < 3; ++k) {
    const std::uint32_t i = kFacet[entered_by][k];
    facet[k] = {facet_link(cell, i), entered.link[i]};
    __builtin_prefetch(&cells[cell_of(entered.link[i])]);
  }
  pending_.grow(counts ? 3 : 0);
}

// The next four facets with a cell beyond that is not in the zone; fewer only at the end.
template <class Site>
inline typename ConflictZone<Site>::Batch ConflictZone<Site>::next_batch(const CellArray& cells) {
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

template <class Site>
inline void ConflictZone<Site>::test(Batch& batch, const CellArray& cells,
                                     const Predicates& predicates, const Request& request) const {
  const typename Tests::Query query{request.sites[request.vertex]};
  std::array<const Cell*, 4> beyond;
  unsigned infinite = 0;
  for (unsigned i = 0; i < 4; ++i) {
    beyond[i] = &cells[cell_of(batch.facet[i < batch.count ? i : 0].outer)];
    infinite |= static_cast<unsigned>(is_infinite(*beyond[i])) << i;
  }
  const SphereBatch known = test_four_(beyond, request.sites, query, predicates.in_sphere_reach());
  batch.in_conflict = known.inside & ~infinite;
  unsigned open = ((1U << batch.count) - 1) & (infinite | ~(known.inside | known.outside));
  for (; open != 0; open &= open - 1) {
    const unsigned lane = static_cast<unsigned>(std::countr_zero(open));
    const bool is_tie = ((known.cospherical & ~infinite) >> lane & 1) != 0;
    const Site& site = request.sites[request.vertex];
    const bool inside = is_tie ? Tests::tie(predicates, {*beyond[lane], request.sites}, site) > 0
                               : is_in_conflict(*beyond[lane], request.sites, site, predicates);
    batch.in_conflict |= static_cast<unsigned>(inside) << lane;
  }
}

template <class Site>
inline void ConflictZone<Site>::sort_out(const Batch& batch, CellArray& cells) {
  pending_.make_room(12 + 3);
  lists_.boundary.make_room(4 + 1);
  lists_.cells.make_room(4 + 1);
  for (unsigned i = 0; i < batch.count; ++i) {
    const SharedFacet facet = batch.facet[i];
    const std::uint32_t beyond = cell_of(facet.outer);
    // An earlier facet of the batch may have led to the same cell.
    const unsigned is_new = is_dead(cells[beyond]) ? 0 : 1;
    const unsigned in_conflict = batch.in_conflict >> i & 1;
    *lists_.boundary.end() = facet;
    lists_.boundary.grow(is_new & ~in_conflict);
    add(cells, beyond, facet_of(facet.outer), (is_new & in_conflict) != 0);
  }
}

template <class Site>
void ConflictZone<Site>::find(CellArray& cells, const Predicates& predicates,
                              const Request& request) {
  lists_.cells.clear();
  pending_.clear();
  lists_.boundary.clear();
  pending_.make_room(4);
  lists_.cells.make_room(1);
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

template bool is_in_conflict(const Cell&, const Point3*, const Point3&, const Predicates&);
template bool is_in_conflict(const Cell&, const WeightedPoint3*, const WeightedPoint3&,
                             const Predicates&);
template class ConflictZone<Point3>;
template class ConflictZone<WeightedPoint3>;

}  // namespace stream_recon::detail
