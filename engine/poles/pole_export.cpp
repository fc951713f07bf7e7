#include "engine/poles/pole_export.h"

#include <algorithm>
#include <limits>
#include <vector>

#include "engine/poles/pole_records.h"
#include "engine/poles/ranked_cell.h"
#include "spatial/touching_ball.h"

namespace stream_recon {
namespace {

/// As often as they are poles, ascending; kInfinity comes last.
std::vector<CellId> cells_of(const FinalWindow& window, const StarPoles& poles) {
  std::vector<CellId> cells;
  cells.reserve(2 * std::size_t{window.owned_count()});
  for (VertexId v = 0; v < window.owned_count(); ++v) {
    const PolePair pair = poles.pair(v);
    for (const CellId cell : {pair.first, pair.second}) {
      if (cell != PolePair::kNone) cells.push_back(cell);
    }
  }
  std::sort(cells.begin(), cells.end());
  return cells;
}

}  // namespace

void export_poles(const FinalWindow& window, const StarPoles& poles, const PoleTraits& traits,
                  ExportWriter& out) {
  const CellView view = window.delaunay().view();
  const std::vector<CellId> cells = cells_of(window, poles);
  for (auto first = cells.begin(); first != cells.end();) {
    const CellId cell = *first;
    const auto last = std::upper_bound(first, cells.end(), cell);
    PoleName name{.tetrahedron = kInfiniteNode,
                  .node = {},
                  .separation = 0,
                  .samples = static_cast<std::uint32_t>(last - first)};
    PoleBall ball{.centre = {}, .radius = std::numeric_limits<double>::infinity()};
    if (cell != PolePair::kInfinity) {
      const RankedCell ranked(window, view, cell);
      name.tetrahedron = ranked.key();
      name.node = traits.attachment(cell);
      const TouchingBall found = touching_ball(ranked.corners(view));
      name.separation = found.separation;
      if (found.is_finite()) ball = {found.centre, found.radius};
      name.is_small = traits.is_too_small(cell, found.radius) ? 1 : 0;
    }
    out.add(ExportKind::kPoleNames, window.first_rank(), name);
    out.add(ExportKind::kPoleBalls, window.first_rank(), ball);
    first = last;
  }
}

}  // namespace stream_recon
