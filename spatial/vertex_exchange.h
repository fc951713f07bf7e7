// Gives the cells of a vertex another vertex at the same place.
//
// Guarantees: afterwards no cell has the old vertex and links are as they were. Thread rule: one
// writer. Memory: a stack of the star's facets. Cost: linear in the star.
#pragma once

#include <cstdint>

#include "spatial/cell_array.h"

namespace stream_recon::detail {

struct VertexExchange {
  std::uint32_t old;
  std::uint32_t now;
};

/// \param holder a cell of the old vertex. \pre No cell has the new vertex; neither is infinity.
void exchange_vertex(CellArray& cells, std::uint32_t holder, const VertexExchange& exchange);

}  // namespace stream_recon::detail
