#include "spatial/point_location.h"

#include <array>
#include <utility>

#include "spatial/site.h"

namespace stream_recon::detail {

template <class Site>
std::uint32_t locate(const CellArray& cells, const Predicates& predicates,
                     const LocationRequest<Site>& request) {
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
    const auto place = [&](int i) { return &position(request.sites[cell.vertex[i]]); };
    std::array<const Point3*, 4> corner = {place(0), place(1), place(2), place(3)};
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

template std::uint32_t locate(const CellArray&, const Predicates&, const LocationRequest<Point3>&);
template std::uint32_t locate(const CellArray&, const Predicates&,
                              const LocationRequest<WeightedPoint3>&);

}  // namespace stream_recon::detail
