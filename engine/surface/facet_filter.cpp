#include "engine/surface/facet_filter.h"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "engine/windows/final_simplices.h"
#include "spatial/gamma_facet.h"

namespace stream_recon {
namespace {

constexpr std::size_t kCellsPerTask = 1 << 14;

/// A facet with its vertices by ascending rank.
struct RankedFacet {
  std::array<VertexId, 3> vertices;
  std::array<PointRank, 3> ranks;
  bool reversed;  ///< an odd permutation of the order it was given in
};

RankedFacet by_rank(const FinalWindow& window, std::array<VertexId, 3> v) {
  bool reversed = false;
  const auto order = [&](int i, int j) {
    if (window.rank(v[i]) < window.rank(v[j])) return;
    std::swap(v[i], v[j]);
    reversed = !reversed;
  };
  order(0, 1);
  order(1, 2);
  order(0, 1);
  return {v, {window.rank(v[0]), window.rank(v[1]), window.rank(v[2])}, reversed};
}

/// The vertex of the neighbouring cell that is not in the facet.
VertexId apex_beyond(const Delaunay& delaunay, CellId cell, int side) {
  return delaunay.vertices(delaunay.neighbor(cell, side))[delaunay.mirror_index(cell, side)];
}

}  // namespace

void FacetFilter::consume(const FinalWindow& window) {
  const Delaunay& delaunay = window.delaunay();
  for (std::size_t begin = 0; begin < delaunay.cell_slots(); begin += kCellsPerTask) {
    const std::size_t end = std::min<std::size_t>(begin + kCellsPerTask, delaunay.cell_slots());
    stop_.check();
    std::vector<FacetRecord> taken;
    const CellRange range{static_cast<CellId>(begin), static_cast<CellId>(end)};
    for_each_final_facet(window, range, [&](CellId cell, int side) {
      const auto facet = by_rank(window, facet_vertices(delaunay, cell, side));
      const std::array<Point3, 3> corners{delaunay.point(facet.vertices[0]),
                                          delaunay.point(facet.vertices[1]),
                                          delaunay.point(facet.vertices[2])};
      const Point3 apex = delaunay.point(delaunay.vertices(cell)[side]);
      const bool hull = delaunay.is_infinite(delaunay.neighbor(cell, side));
      const FacetBalls balls =
          hull ? hull_facet_balls(corners, apex)
               : facet_balls(corners, apex, delaunay.point(apex_beyond(delaunay, cell, side)));
      if (!takes(balls)) return;
      FacetRecord record{facet.ranks, static_cast<float>(gamma_angle(balls)), source_};
      if (hull) record.facing = facet.reversed ? Facing::kInward : Facing::kOutward;
      taken.push_back(record);
    });
    sink_.add(taken);
  }
}

}  // namespace stream_recon
