#include "engine/surface/chunk_facets.h"

#include <algorithm>

#include "engine/surface/buckets.h"

namespace stream_recon {
namespace {

/// Places of the facets in ascending order. A facet's lowest vertex lies in the chunk, and few
/// facets share it.
std::vector<std::uint32_t> ascending_order(std::span<const FacetRecord> facets,
                                           const ChunkVertices& points) {
  Buckets by_lowest(points.size());
  for (const FacetRecord& facet : facets) by_lowest.count(points.position(facet.ranks[0]));
  by_lowest.start();
  std::vector<std::uint32_t> order(facets.size());
  for (std::uint32_t i = 0; i < facets.size(); ++i) {
    order[by_lowest.slot(points.position(facets[i].ranks[0]))] = i;
  }
  by_lowest.for_each([&](std::uint32_t begin, std::uint32_t end) {
    std::sort(order.begin() + begin, order.begin() + end,
              [facets](std::uint32_t a, std::uint32_t b) { return facets[a] < facets[b]; });
  });
  return order;
}

}  // namespace

void add_vertices(std::span<const FacetRecord> facets, ChunkVertices& points) {
  for (const FacetRecord& facet : facets) {
    for (const PointRank rank : facet.ranks) points.add(rank);
  }
  points.number();
}

ChunkFacets::ChunkFacets(std::span<const FacetRecord> records, ChunkVertices& points) {
  add_vertices(records, points);
  vertices = points.ranks();
  triangles.reserve(records.size());
  delta.reserve(records.size());
  source.reserve(records.size());
  facing.reserve(records.size());
  closure.reserve(records.size());
  for (const std::uint32_t i : ascending_order(records, points)) {
    const FacetRecord& facet = records[i];
    triangles.push_back({points.position(facet.ranks[0]), points.position(facet.ranks[1]),
                         points.position(facet.ranks[2])});
    delta.push_back(facet.delta);
    source.push_back(facet.source);
    facing.push_back(facet.facing);
    closure.push_back(closure_of_code(facet.closure));
  }
}

}  // namespace stream_recon
