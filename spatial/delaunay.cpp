#include "spatial/delaunay.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

#include "spatial/cell_array.h"
#include "spatial/cell_view.h"
#include "spatial/conflict_zone.h"
#include "spatial/coordinate_range.h"
#include "spatial/first_simplex.h"
#include "spatial/growable_array.h"
#include "spatial/insertion_rounds.h"
#include "spatial/point_location.h"
#include "spatial/predicates.h"
#include "spatial/star_builder.h"

namespace stream_recon {

using detail::Cell;

// Inside, vertex v of the caller is v + 1, and coordinates are multiplied by scale, the power of
// two that makes the predicates exact (1 unless the cloud's numbers are extreme).
struct Delaunay::Impl {
  Options options;
  GrowableArray<Point3> points;  // points[0] is never a point: infinity
  std::size_t vertices = 0;
  CoordinateRange range;
  double scale = 1;
  double unscale = 1;                   // 1 / scale, a power of two
  Predicates exact{CoordinateRange{}};  // for the range and the scale
  detail::CellArray cells;
  detail::ConflictZone zone;
  detail::StarBuilder star;
  std::uint32_t last_cell = 0;
  int dimension = -1;
  bool is_unusable = false;

  std::size_t point_bytes() const { return (vertices + 1) * (sizeof(Point3) + 1); }
  std::size_t most_cells() const;
  bool append(std::span<const Point3> added);
  Predicates predicates() const;
  bool insert_rounds(std::size_t first, const detail::FirstSimplex& done);
};

// How many cell slots the limit leaves. An eighth of a cell is room for the lists of free ones.
std::size_t Delaunay::Impl::most_cells() const {
  const std::size_t taken = point_bytes() + zone.bytes() + star.bytes();
  if (options.max_bytes <= taken) return 0;
  return std::min((options.max_bytes - taken) / (sizeof(Cell) + sizeof(Cell) / 8),
                  detail::CellArray::kMostCells);
}

// Stores the points, scaled; false if their range allows no exact arithmetic.
bool Delaunay::Impl::append(std::span<const Point3> added) {
  for (const Point3& p : added) range.extend(p);
  const std::optional<double> new_scale = range.scale();
  if (!new_scale) return false;
  const std::size_t needed = vertices + added.size() + 1;
  if (needed > points.capacity()) {
    const std::size_t room = std::max(needed, points.capacity() + points.capacity() / 2);
    points.reserve(room);
    star.reserve_vertices(room);
  }
  const auto times = [](const Point3& p, double s) { return Point3{p.x * s, p.y * s, p.z * s}; };
  if (*new_scale != scale) {
    for (std::size_t v = 1; v <= vertices; ++v) {
      points[v] = times(times(points[v], 1 / scale), *new_scale);
    }
    scale = *new_scale;
    unscale = 1 / scale;
  }
  for (const Point3& p : added) points[++vertices] = times(p, scale);
  exact = predicates();
  return true;
}

Predicates Delaunay::Impl::predicates() const {
  return Predicates(range.times(scale));
}

// Inserts all vertices from `first` on but those of the first simplex; false if memory ran out.
bool Delaunay::Impl::insert_rounds(std::size_t first, const detail::FirstSimplex& done) {
  const std::size_t limit = most_cells();
  const detail::InsertionRounds rounds(vertices + 1 - first);
  for (int round = rounds.last(); round >= 0; --round) {
    for (std::size_t v = first; v <= vertices; ++v) {
      if (rounds.round_of(v - first) != round) continue;
      const auto vertex = static_cast<std::uint32_t>(v);
      if (std::ranges::find(done.vertices, vertex) != done.vertices.end()) continue;
      const std::uint32_t at =
          detail::locate(cells, exact, {points.data(), last_cell, points[vertex]});
      zone.find(cells, exact, {points.data(), vertex, at});
      if (!cells.make_room(zone.boundary().size(), limit)) return false;
      last_cell = star.build(cells, zone, vertex);
    }
  }
  return true;
}

Delaunay::Delaunay() : Delaunay(Options{}) {}
Delaunay::Delaunay(const Options& options) : impl_(std::make_unique<Impl>()) {
  impl_->options = options;
  impl_->range = options.range;
}
Delaunay::~Delaunay() = default;
Delaunay::Delaunay(Delaunay&&) noexcept = default;
Delaunay& Delaunay::operator=(Delaunay&&) noexcept = default;

void Delaunay::set_max_bytes(std::size_t max_bytes) {
  impl_->options.max_bytes = max_bytes;
}

Delaunay::Outcome Delaunay::insert(std::span<const Point3> added) {
  Impl& self = *impl_;
  assert(!self.is_unusable);
  self.is_unusable = true;  // until the insertion is whole
  if (self.vertices + added.size() >= kInfinite) return Outcome::kOutgrown;
  std::size_t first = self.vertices + 1;
  if (!self.append(added)) return Outcome::kBadRange;
  detail::FirstSimplex simplex;
  if (self.dimension < 3) {
    first = 1;
    simplex = detail::find_first_simplex({&self.points[1], self.vertices}, 1, self.exact);
    self.dimension = simplex.dimension;
    if (self.dimension < 3) {
      self.is_unusable = false;
      return Outcome::kFlat;
    }
    detail::make_first_cells(self.cells, simplex);
  }
  if (!self.insert_rounds(first, simplex)) return Outcome::kOutgrown;
  self.is_unusable = false;
  return Outcome::kDone;
}

bool Delaunay::in_conflict(CellId c, const Point3& p) const {
  const double s = impl_->scale;
  return detail::is_in_conflict(impl_->cells[c], impl_->points.data(), {p.x * s, p.y * s, p.z * s},
                                impl_->exact);
}

int Delaunay::dimension() const {
  return impl_->dimension;
}
std::size_t Delaunay::vertex_count() const {
  return impl_->vertices;
}

Point3 Delaunay::point(VertexId v) const {
  const Point3& p = impl_->points[v + 1];
  const double s = impl_->unscale;
  return {p.x * s, p.y * s, p.z * s};
}

CellId Delaunay::cell_slots() const {
  return static_cast<CellId>(impl_->cells.size());
}
bool Delaunay::is_live(CellId c) const {
  return !detail::is_dead(impl_->cells[c]);
}
bool Delaunay::is_infinite(CellId c) const {
  return detail::is_infinite(impl_->cells[c]);
}

std::array<VertexId, 4> Delaunay::vertices(CellId c) const {
  const Cell& cell = impl_->cells[c];
  // Infinity, 0 inside, becomes kInfinite by wrapping around.
  const auto outside = [](std::uint32_t vertex) { return (vertex - 1) & kInfinite; };
  return {outside(detail::vertex_of(cell, 0)), outside(cell.vertex[1]), outside(cell.vertex[2]),
          outside(cell.vertex[3])};
}

CellId Delaunay::neighbor(CellId c, int i) const {
  return detail::cell_of(impl_->cells[c].link[i]);
}
int Delaunay::mirror_index(CellId c, int i) const {
  return static_cast<int>(detail::facet_of(impl_->cells[c].link[i]));
}

CellView Delaunay::view() const {
  return CellView({.cells = impl_->cells.data(),
                   .slots = cell_slots(),
                   .points = impl_->points.data(),
                   .scale = impl_->scale});
}

std::size_t Delaunay::finite_cell_count() const {
  std::size_t count = 0;
  for (CellId c = 0; c < cell_slots(); ++c) count += is_live(c) && !is_infinite(c) ? 1 : 0;
  return count;
}

std::size_t Delaunay::bytes() const {
  return impl_->point_bytes() + impl_->cells.bytes() + impl_->zone.bytes() + impl_->star.bytes();
}

}  // namespace stream_recon
