#include "engine/windows/tetrahedra_census.h"

#include "engine/windows/final_simplices.h"

namespace stream_recon {

void TetrahedraCensus::consume(const FinalWindow& window) {
  const CellView cells = window.delaunay().view();
  std::uint64_t count = 0;
  SimplexDigest digest;
  for_each_final_tetrahedron(window, {0, cells.slots()}, [&](CellId cell) {
    const auto v = cells.vertices(cell);
    digest.add<4>({window.input_index(v[0]), window.input_index(v[1]), window.input_index(v[2]),
                   window.input_index(v[3])});
    ++count;
  });
  const std::lock_guard lock(mutex_);
  count_ += count;
  digest_.merge(digest);
}

}  // namespace stream_recon
