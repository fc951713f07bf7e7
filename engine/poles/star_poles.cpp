#include "engine/poles/star_poles.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "engine/poles/ranked_cell.h"
#include "spatial/cell_view.h"
#include "spatial/vector.h"

namespace stream_recon {
namespace {

/// Calls visit(cell, vertex, vector from the vertex to the circumcentre) for the owned corners of
/// all finite cells.
template <class Visit>
void for_each_corner(const FinalWindow& window, const StarBalls& balls, const Visit& visit) {
  const CellView cells = window.delaunay().view();
  std::uint32_t number = 0;
  balls.cells().for_each([&](CellId cell) { cells.prefetch_points(cell); },
                         [&](CellId cell) {
                           for (const VertexId v : cells.vertices(cell)) {
                             if (window.owns_vertex(v)) visit(cell, v, balls.from(v, number));
                           }
                           ++number;
                         });
}

/// Whether `cell`, at this squared distance, is to be preferred.
bool is_farther(const FinalWindow& window, double square, CellId cell, double best_square,
                CellId best) {
  if (square != best_square || best == PolePair::kNone) return square > best_square;
  const CellView cells = window.delaunay().view();
  return RankedCell(window, cells, cell).ranks < RankedCell(window, cells, best).ranks;
}

/// Sums of whole numbers do not depend on their order.
constexpr double kUnit = 0x1p30;

}  // namespace

StarPoles::StarPoles(const FinalWindow& window, const StarBalls& balls)
    : samples_(window.owned_count()) {
  find_hull(window);
  find_first(window, balls);
  for (Sample& sample : samples_) sample.square = 0;
  find_second(window, balls);
}

void StarPoles::find_hull(const FinalWindow& window) {
  const CellView cells = window.delaunay().view();
  for (CellId cell = 0; cell < cells.slots(); ++cell) {
    if (!cells.is_live(cell) || !cells.is_infinite(cell)) continue;
    // The facet as the finite cell behind it has it is seen counterclockwise from outside.
    constexpr int kFinite = 3;
    const auto v = cells.facet(cells.neighbor(cell, kFinite), cells.mirror_index(cell, kFinite));
    std::array<VertexId, 3> turned = v;
    const auto lowest = std::min_element(turned.begin(), turned.end(), [&](VertexId a, VertexId b) {
      return window.rank(a) < window.rank(b);
    });
    std::rotate(turned.begin(), lowest, turned.end());
    const Point3 a = cells.point(turned[0]);
    const Point3 normal = cross(minus(cells.point(turned[1]), a), minus(cells.point(turned[2]), a));
    const double size = length(normal);
    if (!(size > 0)) continue;
    const Point3 whole{std::nearbyint(normal.x / size * kUnit),
                       std::nearbyint(normal.y / size * kUnit),
                       std::nearbyint(normal.z / size * kUnit)};
    for (const VertexId corner : v) {
      if (!window.owns_vertex(corner)) continue;
      Sample& sample = samples_[corner];
      sample.poles.first = PolePair::kInfinity;
      sample.direction = plus(sample.direction, whole);
    }
  }
}

void StarPoles::find_first(const FinalWindow& window, const StarBalls& balls) {
  for_each_corner(window, balls, [&](CellId cell, VertexId v, const Point3& centre) {
    Sample& sample = samples_[v];
    if (sample.poles.first == PolePair::kInfinity) return;
    const double square = dot(centre, centre);
    if (!is_farther(window, square, cell, sample.square, sample.poles.first)) return;
    sample.poles.first = cell;
    sample.square = square;
    sample.direction = centre;
  });
}

void StarPoles::find_second(const FinalWindow& window, const StarBalls& balls) {
  for_each_corner(window, balls, [&](CellId cell, VertexId v, const Point3& centre) {
    Sample& sample = samples_[v];
    if (!(dot(centre, sample.direction) < 0)) return;
    const double square = dot(centre, centre);
    if (!is_farther(window, square, cell, sample.square, sample.poles.second)) return;
    sample.poles.second = cell;
    sample.square = square;
  });
}

PoleBalls StarPoles::balls_of(VertexId v, const StarBalls& balls) const {
  const Sample& sample = samples_[v];
  const Point3 second = balls.from(v, balls.cells().position(sample.poles.second));
  const double radius = std::sqrt(sample.square);
  const double size = length(sample.direction);
  return {.cosine = -dot(second, sample.direction) / (radius * size),
          .radius = sample.poles.first == PolePair::kInfinity ? radius : std::min(size, radius)};
}

}  // namespace stream_recon
