#include "spatial/point_location.h"

#include <array>
#include <utility>

namespace stream_recon::detail {

std::uint32_t locate(const CellArray& cells, const Predicates& predicates,
                     const LocationRequest& request) {
  std::uint32_t at = request.start_cell;
  std::uint32_t entered_by = 4;
  const auto cross = [&](int facet) {
    const std::uint32_t link = cells[at].link[facet];
    at = cell_of(link);
    entered_by = facet_of(link);
  };
  if (is_infinite(cells[at])) at = cell_of(cells[at].link[3]);
  for (;;) {
    const Cell& cell = cells[at];
    if (is_infinite(cell)) return at;
    std::array<const Point3*, 4> corner = {
        &request.points[cell.vertex[0]], &request.points[cell.vertex[1]],
        &request.points[cell.vertex[2]], &request.points[cell.vertex[3]]};
    std::uint32_t exit = 4;
    for (std::uint32_t i = 0; i < 4 && exit == 4; ++i) {
      if (i == entered_by) continue;
      const Point3* const opposite = std::exchange(corner[i], &request.query);
      if (predicates.orient3d(*corner[0], *corner[1], *corner[2], *corner[3]) < 0) exit = i;
      corner[i] = opposite;
    }
    if (exit == 4) return at;
    cross(static_cast<int>(exit));
  }
}

}  // namespace stream_recon::detail
