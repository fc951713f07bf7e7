#include "engine/surface/facet_sink.h"

namespace stream_recon {

void FacetSink::add(std::span<const FacetRecord> facets) {
  const std::lock_guard lock(mutex_);
  for (const FacetRecord& facet : facets) {
    const std::uint64_t chunk = layout_.chunk_of(facet.ranks[0]);
    facets_.append(chunk, facet);
    for (int i = 1; i < 3; ++i) {
      const std::uint64_t owner = layout_.chunk_of(facet.ranks[i]);
      if (owner != chunk) border_points_.append(owner, {facet.ranks[i], chunk});
    }
    const std::uint64_t far_side = layout_.chunk_of(facet.ranks[1]);
    if (far_side != chunk) border_edges_.append(far_side, {facet.ranks[1], facet.ranks[2]});
  }
}

void FacetSink::finish() {
  facets_.finish();
  border_points_.finish();
  border_edges_.finish();
}

}  // namespace stream_recon
