#include "engine/tetrahedra/tetrahedra_collector.h"

#include <algorithm>
#include <array>
#include <utility>

#include "engine/tetrahedra/tetrahedron_record.h"
#include "engine/windows/export_writer.h"
#include "engine/windows/final_simplices.h"

namespace stream_recon {
namespace {

constexpr CellId kBlock = 1 << 14;

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

void TetrahedraCollector::consume(const FinalWindow& window, ExportWriter& out) {
  const CellId end = window.delaunay().cell_slots();
  for (CellId begin = 0; begin < end; begin += std::min(kBlock, end - begin)) {
    stop_.check();
    for_each_final_tetrahedron(
        window, {begin, begin + std::min(kBlock, end - begin)}, [&](CellId cell) {
          const TetrahedronRecord record = record_of(window, cell);
          out.add(ExportKind::kTetrahedra, layout_.chunk_of(record.ranks[0]), record);
        });
  }
}

}  // namespace stream_recon
