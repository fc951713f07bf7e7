#include "tools/kernel_bench/pole_sites.h"

#include <algorithm>
#include <array>

#include "io/error.h"
#include "spatial/cell_view.h"
#include "spatial/circumball.h"
#include "spatial/delaunay.h"
#include "spatial/vector.h"

namespace stream_recon {
namespace {

constexpr CellId kNone = static_cast<CellId>(-1);

struct Sample {
  Point3 direction;  // towards the first pole
  double first_square = 0;
  double second_square = 0;
  CellId first = kNone;
  CellId second = kNone;
  bool is_on_hull = false;
};

// The corners by ascending number, so that the centre does not depend on how the cell came about.
Circumball ball_of(const CellView& cells, CellId cell) {
  std::array<VertexId, 4> vertices = cells.vertices(cell);
  std::sort(vertices.begin(), vertices.end());
  std::array<Point3, 4> corners;
  for (int i = 0; i < 4; ++i) corners[i] = cells.point(vertices[i]);
  return circumball(corners);
}

// Calls visit(sample, cell, vector from the sample to the circumcentre) for finite cells.
template <class Visit>
void for_each_corner(const CellView& cells, std::vector<Sample>& samples, const Visit& visit) {
  for (CellId c = 0; c < cells.slots(); ++c) {
    if (!cells.is_live(c) || cells.is_infinite(c)) continue;
    const Circumball ball = ball_of(cells, c);
    for (const VertexId v : cells.vertices(c))
      visit(samples[v], c, minus(plus(ball.origin, ball.centre), cells.point(v)));
  }
}

void find_hull(const CellView& cells, std::vector<Sample>& samples) {
  for (CellId c = 0; c < cells.slots(); ++c) {
    if (!cells.is_live(c) || !cells.is_infinite(c)) continue;
    // The hull lies counterclockwise seen from outside.
    const auto v = cells.vertices(c);
    const Point3 a = cells.point(v[0]);
    const Point3 normal = cross(minus(cells.point(v[1]), a), minus(cells.point(v[2]), a));
    const double size = length(normal);
    for (int i = 0; i < 3; ++i) {
      Sample& sample = samples[v[i]];
      sample.is_on_hull = true;
      if (size > 0) sample.direction = plus(sample.direction, scaled(normal, 1 / size));
    }
  }
}

WeightedPoint3 site_of(const CellView& cells, CellId cell) {
  const Circumball ball = ball_of(cells, cell);
  return {plus(ball.origin, ball.centre), dot(ball.centre, ball.centre)};
}

// The cells that are poles, each once.
std::vector<CellId> pole_cells(const std::vector<Sample>& samples) {
  std::vector<CellId> poles;
  for (const Sample& sample : samples) {
    for (const CellId cell : {sample.first, sample.second})
      if (cell != kNone) poles.push_back(cell);
  }
  std::sort(poles.begin(), poles.end());
  poles.erase(std::unique(poles.begin(), poles.end()), poles.end());
  return poles;
}

// The balls of the cells by place, the heaviest of each place.
std::vector<WeightedPoint3> sites_of(const CellView& cells, const std::vector<CellId>& poles) {
  std::vector<WeightedPoint3> sites;
  sites.reserve(poles.size());
  for (const CellId cell : poles) sites.push_back(site_of(cells, cell));
  std::sort(sites.begin(), sites.end(), [](const WeightedPoint3& a, const WeightedPoint3& b) {
    return a.point == b.point ? a.weight > b.weight : a.point < b.point;
  });
  sites.erase(std::unique(sites.begin(), sites.end(),
                          [](const auto& a, const auto& b) { return a.point == b.point; }),
              sites.end());
  return sites;
}

}  // namespace

std::vector<WeightedPoint3> pole_sites(const std::vector<Point3>& points) {
  Delaunay delaunay;
  const Delaunay::Outcome outcome = delaunay.insert(points);
  if (outcome == Delaunay::Outcome::kBadRange)
    throw InputError("coordinates too far apart in magnitude for exact arithmetic: scale them");
  const CellView cells = delaunay.view();
  std::vector<Sample> samples(points.size());
  find_hull(cells, samples);
  for_each_corner(cells, samples, [](Sample& sample, CellId cell, const Point3& to) {
    const double square = dot(to, to);
    if (sample.is_on_hull || !(square > sample.first_square)) return;
    sample.first = cell;
    sample.first_square = square;
    sample.direction = to;
  });
  for_each_corner(cells, samples, [](Sample& sample, CellId cell, const Point3& to) {
    const double square = dot(to, to);
    if (!(square > sample.second_square) || !(dot(to, sample.direction) < 0)) return;
    sample.second = cell;
    sample.second_square = square;
  });

  return sites_of(cells, pole_cells(samples));
}

}  // namespace stream_recon
