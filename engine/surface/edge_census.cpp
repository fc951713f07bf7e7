#include "engine/surface/edge_census.h"

namespace stream_recon {

void EdgeCensus::add(const ChunkEdges& chunk) {
  std::size_t next = 0;
  const auto& handed = chunk.handed_over;
  const auto take_equal = [&](const BorderEdge& edge) {
    std::uint64_t uses = 0;
    for (; next < handed.size() && handed[next] == edge; ++next) ++uses;
    return uses;
  };
  const auto count_before = [&](const BorderEdge& edge) {
    while (next < handed.size() && handed[next] < edge) count(take_equal(BorderEdge(handed[next])));
  };

  for_each_edge(chunk.uses, [&](std::span<const EdgeUse> uses) {
    const BorderEdge edge{chunk.ranks[uses[0].low], chunk.ranks[uses[0].high]};
    if (edge.low >= chunk.end) return;
    count_before(edge);
    count(uses.size() + take_equal(edge));
  });
  while (next < handed.size()) count(take_equal(BorderEdge(handed[next])));
}

void EdgeCensus::count(std::uint64_t uses) {
  ++edges_;
  if (uses == 1) ++boundary_;
  if (uses > 2) ++nonmanifold_;
}

}  // namespace stream_recon
