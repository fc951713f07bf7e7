#include "engine/windows/tetrahedra_census.h"

#include <mutex>

#include "engine/parallel.h"
#include "engine/windows/final_simplices.h"

namespace stream_recon {
namespace {

constexpr std::size_t kCellsPerTask = 1 << 14;

}  // namespace

void TetrahedraCensus::consume(const FinalWindow& window) {
  std::mutex mutex;
  const Delaunay& delaunay = window.delaunay();
  parallel_for_ranges(delaunay.cell_slots(), kCellsPerTask,
                      [&](std::size_t begin, std::size_t end) {
                        std::uint64_t count = 0;
                        SimplexDigest digest;
                        const CellRange range{static_cast<CellId>(begin), static_cast<CellId>(end)};
                        for_each_final_tetrahedron(window, range, [&](CellId cell) {
                          const auto v = delaunay.vertices(cell);
                          digest.add<4>({window.input_index(v[0]), window.input_index(v[1]),
                                         window.input_index(v[2]), window.input_index(v[3])});
                          ++count;
                        });
                        const std::lock_guard lock(mutex);
                        count_ += count;
                        digest_.merge(digest);
                      });
}

}  // namespace stream_recon
