#include "spatial/vertex_exchange.h"

#include <algorithm>
#include <vector>

namespace stream_recon::detail {

void exchange_vertex(CellArray& cells, std::uint32_t holder, const VertexExchange& exchange) {
  std::vector<std::uint32_t> pending{holder};
  while (!pending.empty()) {
    Cell& cell = cells[pending.back()];
    pending.pop_back();
    std::uint32_t* const end = cell.vertex + 4;
    std::uint32_t* const place = std::find(cell.vertex, end, exchange.old);
    if (place == end) continue;
    *place = exchange.now;
    for (int i = 0; i < 4; ++i) {
      if (i != place - cell.vertex) pending.push_back(cell_of(cell.link[i]));
    }
  }
}

}  // namespace stream_recon::detail
