#include "spatial/incremental_kernel.h"

#include <algorithm>
#include <cassert>
#include <optional>

#include "spatial/insertion_rounds.h"
#include "spatial/point_location.h"
#include "spatial/vertex_exchange.h"

namespace stream_recon::detail {

// How many cell slots the limit leaves. An eighth of a cell is room for the lists of free ones.
template <class Site>
std::size_t IncrementalKernel<Site>::most_cells() const {
  const std::size_t taken = site_bytes() + zone_.bytes() + star_.bytes();
  if (max_bytes_ <= taken) return 0;
  return std::min((max_bytes_ - taken) / (sizeof(Cell) + sizeof(Cell) / 8), CellArray::kMostCells);
}

template <class Site>
void IncrementalKernel<Site>::reserve(std::size_t count) {
  if (count <= sites_.capacity()) return;
  const std::size_t room = std::max(count, sites_.capacity() + sites_.capacity() / 2);
  sites_.reserve(room);
  star_.reserve_vertices(room);
  if (kMayHide) hidden_.reserve(room);
}

// Stores the sites, scaled; false if their range allows no exact arithmetic.
template <class Site>
bool IncrementalKernel<Site>::append(std::span<const Site> added) {
  for (const Site& site : added) range_.extend(site);
  const std::optional<double> new_scale = range_.scale();
  if (!new_scale) return false;
  reserve(count_ + added.size() + 1);
  if (*new_scale != scale_) {
    for (std::size_t v = 1; v <= count_; ++v)
      sites_[v] = scaled(scaled(sites_[v], 1 / scale_), *new_scale);
    scale_ = *new_scale;
  }
  for (const Site& site : added) sites_[++count_] = scaled(site, scale_);
  exact_ = Predicates(range_.times(scale_));
  return true;
}

// The site is no vertex: the located cell is a finite one. Of two equal sites the first stays.
template <class Site>
void IncrementalKernel<Site>::hide(std::uint32_t vertex, std::uint32_t holder) {
  for (int i = 0; i < 4; ++i) {
    const std::uint32_t corner = cells_[holder].vertex[i];
    if (corner < vertex || !(sites_[corner] == sites_[vertex])) continue;
    exchange_vertex(cells_, holder, {.old = corner, .now = vertex});
    vertex = corner;
  }
  hidden_.add(vertex);
}

// False if memory ran out.
template <class Site>
bool IncrementalKernel<Site>::insert_vertex(std::uint32_t vertex, std::size_t most_cells) {
  const Site& site = sites_[vertex];
  const std::uint32_t at =
      locate<Site>(cells_, exact_, {sites_.data(), last_cell_, position(site)});
  if constexpr (kMayHide) {
    if (!is_in_conflict(cells_[at], sites_.data(), site, exact_)) {
      last_cell_ = at;
      hide(vertex, at);
      return true;
    }
  }
  zone_.find(cells_, exact_, {sites_.data(), vertex, at});
  if (!cells_.make_room(zone_.lists().boundary.size(), most_cells)) return false;
  last_cell_ = star_.build(cells_, zone_.lists(), vertex);
  if constexpr (kMayHide) {
    swallowed_.clear();
    star_.find_swallowed(cells_, zone_.lists(), swallowed_);
    for (const std::uint32_t hidden : swallowed_) hidden_.add(hidden);
  }
  return true;
}

// Inserts all vertices from `first` on but those of the first simplex; false if memory ran out.
template <class Site>
bool IncrementalKernel<Site>::insert_rounds(std::size_t first, const FirstSimplex& done) {
  const std::size_t limit = most_cells();
  const InsertionRounds rounds(count_ + 1 - first);
  for (int round = rounds.last(); round >= 0; --round) {
    for (std::size_t v = first; v <= count_; ++v) {
      if (rounds.round_of(v - first) != round) continue;
      const auto vertex = static_cast<std::uint32_t>(v);
      if (std::ranges::find(done.vertices, vertex) != done.vertices.end()) continue;
      if (!insert_vertex(vertex, limit)) return false;
    }
  }
  return true;
}

template <class Site>
Delaunay::Outcome IncrementalKernel<Site>::insert(std::span<const Site> added) {
  assert(!is_unusable_);
  is_unusable_ = true;  // until the insertion is whole
  if (count_ + added.size() >= Delaunay::kInfinite) return Outcome::kOutgrown;
  std::size_t first = count_ + 1;
  if (!append(added)) return Outcome::kBadRange;
  FirstSimplex simplex;
  if (dimension_ < 3) {
    first = 1;
    simplex = find_first_simplex(std::span<const Site>(&sites_[1], count_), 1, exact_);
    dimension_ = simplex.dimension;
    if (dimension_ < 3) {
      is_unusable_ = false;
      return Outcome::kFlat;
    }
    make_first_cells(cells_, simplex);
  }
  if (!insert_rounds(first, simplex)) return Outcome::kOutgrown;
  is_unusable_ = false;
  return Outcome::kDone;
}

template <class Site>
std::size_t IncrementalKernel<Site>::finite_cell_count() const {
  const BasicCellView<Site> cells = view();
  std::size_t count = 0;
  for (CellId c = 0; c < cells.slots(); ++c)
    count += cells.is_live(c) && !cells.is_infinite(c) ? 1 : 0;
  return count;
}

template class IncrementalKernel<Point3>;
template class IncrementalKernel<WeightedPoint3>;

}  // namespace stream_recon::detail
