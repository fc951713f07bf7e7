#include "engine/surface/chunk_stars.h"

#include <algorithm>

namespace stream_recon {

ChunkStars::ChunkStars(const ChunkFacets& own_facets, std::span<const FacetRecord> border)
    : own(static_cast<std::uint32_t>(own_facets.triangles.size())) {
  ranks.reserve(3 * border.size() + own_facets.vertices.size());
  for (const FacetRecord& facet : border) {
    ranks.insert(ranks.end(), facet.ranks.begin(), facet.ranks.end());
  }
  ranks.insert(ranks.end(), own_facets.vertices.begin(), own_facets.vertices.end());
  std::sort(ranks.begin(), ranks.end());
  ranks.erase(std::unique(ranks.begin(), ranks.end()), ranks.end());
  triangles.reserve(own + border.size());
  is_outward.reserve(own + border.size());
  add_own(own_facets);
  for (const FacetRecord& facet : border) {
    const auto& v = facet.ranks;
    triangles.push_back({position(v[0]), position(v[1]), position(v[2])});
    is_outward.push_back(facet.facing == Facing::kOutward);
  }
}

std::uint32_t ChunkStars::position(PointRank rank) const {
  const auto at = std::lower_bound(ranks.begin(), ranks.end(), rank);
  return static_cast<std::uint32_t>(at - ranks.begin());
}

void ChunkStars::add_own(const ChunkFacets& facets) {
  std::vector<std::uint32_t> place;
  place.reserve(facets.vertices.size());
  auto next = ranks.begin();
  for (const PointRank rank : facets.vertices) {
    next = std::find(next, ranks.end(), rank);
    place.push_back(static_cast<std::uint32_t>(next - ranks.begin()));
  }
  for (const LocalTriangle& v : facets.triangles) {
    triangles.push_back({place[v[0]], place[v[1]], place[v[2]]});
  }
  for (const Facing facing : facets.facing) is_outward.push_back(facing == Facing::kOutward);
}

}  // namespace stream_recon
