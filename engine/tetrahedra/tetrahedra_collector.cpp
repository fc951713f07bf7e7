#include "engine/tetrahedra/tetrahedra_collector.h"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "engine/windows/final_simplices.h"

namespace stream_recon {
namespace {

constexpr std::size_t kBatch = (std::size_t{64} << 10) / sizeof(TetrahedronRecord);

/// The cell is positively oriented, so an odd number of swaps is undone by one more.
TetrahedronRecord record_of(const FinalWindow& window, CellId cell) {
  TetrahedronRecord record;
  auto& ranks = record.ranks;
  const auto vertices = window.delaunay().vertices(cell);
  for (int i = 0; i < 4; ++i) ranks[i] = window.rank(vertices[i]);
  bool is_odd = false;
  static constexpr std::array<std::pair<int, int>, 5> kSortFour{
      {{0, 1}, {2, 3}, {0, 2}, {1, 3}, {1, 2}}};
  for (const auto& [low, high] : kSortFour) {
    if (ranks[low] < ranks[high]) continue;
    std::swap(ranks[low], ranks[high]);
    is_odd = !is_odd;
  }
  if (is_odd) std::swap(ranks[2], ranks[3]);
  return record;
}

}  // namespace

void TetrahedraCollector::consume(const FinalWindow& window) {
  std::vector<TetrahedronRecord> found;
  found.reserve(kBatch);
  const auto hand_over = [&] {
    stop_.check();
    sink_.add(found);
    found.clear();
  };
  for_each_final_tetrahedron(window, {0, window.delaunay().cell_slots()}, [&](CellId cell) {
    found.push_back(record_of(window, cell));
    if (found.size() == kBatch) hand_over();
  });
  hand_over();
}

}  // namespace stream_recon
