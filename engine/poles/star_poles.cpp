#include "engine/poles/star_poles.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "spatial/cell_view.h"
#include "spatial/circumball.h"
#include "spatial/vector.h"

namespace stream_recon {
namespace {

using CellRanks = std::array<PointRank, 4>;

/// A finite cell with its corners by ascending rank.
struct RankedCell {
  std::array<VertexId, 4> vertices;

  RankedCell(const FinalWindow& window, const CellView& cells, CellId cell)
      : vertices(cells.vertices(cell)) {
    std::sort(vertices.begin(), vertices.end(),
              [&](VertexId a, VertexId b) { return window.rank(a) < window.rank(b); });
  }
};

CellRanks ranks_of(const FinalWindow& window, const CellView& cells, CellId cell) {
  const RankedCell ranked(window, cells, cell);
  CellRanks ranks;
  for (int i = 0; i < 4; ++i) ranks[i] = window.rank(ranked.vertices[i]);
  return ranks;
}

/// Calls visit(cell, vertex, vector from the vertex to the circumcentre) for the owned corners of
/// all finite cells.
template <class Visit>
void for_each_corner(const FinalWindow& window, const Visit& visit) {
  const CellView cells = window.delaunay().view();
  for (CellId cell = 0; cell < cells.slots(); ++cell) {
    if (!cells.is_live(cell) || cells.is_infinite(cell)) continue;
    const auto v = cells.vertices(cell);
    if (!window.owns_vertex(std::min(std::min(v[0], v[1]), std::min(v[2], v[3])))) continue;
    const RankedCell ranked(window, cells, cell);
    std::array<Point3, 4> corners;
    for (int i = 0; i < 4; ++i) corners[i] = cells.point(ranked.vertices[i]);
    const Circumball ball = circumball(corners);
    for (int i = 0; i < 4; ++i) {
      if (!window.owns_vertex(ranked.vertices[i])) continue;
      visit(cell, ranked.vertices[i], plus(minus(corners[0], corners[i]), ball.centre));
    }
  }
}

/// Whether `cell`, at this squared distance, is to be preferred.
bool is_farther(const FinalWindow& window, double square, CellId cell, double best_square,
                CellId best) {
  if (best == PolePair::kNone || square != best_square) return square > best_square;
  const CellView cells = window.delaunay().view();
  return ranks_of(window, cells, cell) < ranks_of(window, cells, best);
}

/// Sums of whole numbers do not depend on their order.
constexpr double kUnit = 0x1p30;

}  // namespace

StarPoles::StarPoles(const FinalWindow& window) : samples_(window.owned_count()) {
  find_hull(window);
  find_first(window);
  find_second(window);
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
      sample.first = PolePair::kInfinity;
      sample.direction = plus(sample.direction, whole);
    }
  }
}

void StarPoles::find_first(const FinalWindow& window) {
  for_each_corner(window, [&](CellId cell, VertexId v, const Point3& centre) {
    Sample& sample = samples_[v];
    if (sample.first == PolePair::kInfinity) return;
    const double square = dot(centre, centre);
    if (!is_farther(window, square, cell, sample.first_square, sample.first)) return;
    sample.first = cell;
    sample.first_square = square;
    sample.direction = centre;
  });
}

void StarPoles::find_second(const FinalWindow& window) {
  for_each_corner(window, [&](CellId cell, VertexId v, const Point3& centre) {
    Sample& sample = samples_[v];
    const double along = dot(centre, sample.direction);
    if (!(along < 0)) return;
    const double square = dot(centre, centre);
    if (!is_farther(window, square, cell, sample.second_square, sample.second)) return;
    sample.second = cell;
    sample.second_square = square;
    sample.second_along = along;
  });
}

PolePair StarPoles::pair(VertexId v) const {
  const Sample& sample = samples_[v];
  PolePair result{.first = sample.first, .second = sample.second, .balls = {}};
  if (!result.is_complete()) return result;
  const double lengths = std::sqrt(sample.second_square) * length(sample.direction);
  result.balls.cosine = -sample.second_along / lengths;
  result.balls.radius = std::sqrt(sample.first == PolePair::kInfinity
                                      ? sample.second_square
                                      : std::min(sample.first_square, sample.second_square));
  return result;
}

}  // namespace stream_recon
