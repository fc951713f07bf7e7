#include "engine/windows/tetrahedra_census.h"

#include "engine/windows/final_simplices.h"

namespace stream_recon {

TetrahedraCensus take_census(const FinalWindow& window) {
  const CellView cells = window.delaunay().view();
  TetrahedraCensus census;
  for_each_final_tetrahedron(window, {0, cells.slots()}, [&](CellId cell) {
    const auto v = cells.vertices(cell);
    census.digest.add<4>({window.input_index(v[0]), window.input_index(v[1]),
                          window.input_index(v[2]), window.input_index(v[3])});
    ++census.count;
  });
  return census;
}

}  // namespace stream_recon
