#include "engine/surface/chunk_facets.h"

#include <algorithm>
#include <functional>
#include <utility>

#include "engine/parallel.h"

namespace stream_recon {

std::vector<PointRank> vertex_ranks(std::span<const FacetRecord> facets) {
  std::vector<PointRank> ranks;
  ranks.reserve(3 * facets.size());
  for (const FacetRecord& facet : facets) {
    ranks.insert(ranks.end(), facet.ranks.begin(), facet.ranks.end());
  }
  parallel_sort(ranks.begin(), ranks.end(), std::less<>());
  ranks.erase(std::unique(ranks.begin(), ranks.end()), ranks.end());
  ranks.shrink_to_fit();
  return ranks;
}

ChunkFacets::ChunkFacets(std::vector<FacetRecord> records) : facets(std::move(records)) {
  parallel_sort(facets.begin(), facets.end(), std::less<>());
  vertices = vertex_ranks(facets);
  triangles.reserve(facets.size());
  const auto position = [this](PointRank rank) {
    const auto at = std::lower_bound(vertices.begin(), vertices.end(), rank);
    return static_cast<std::uint32_t>(at - vertices.begin());
  };
  for (const FacetRecord& facet : facets) {
    triangles.push_back(
        {position(facet.ranks[0]), position(facet.ranks[1]), position(facet.ranks[2])});
  }
}

}  // namespace stream_recon
