#include "engine/surface/facet_export.h"

namespace stream_recon {

void export_facets(std::span<const FacetRecord> facets, const ChunkLayout& layout,
                   ExportWriter& out) {
  for (const FacetRecord& facet : facets) {
    const std::uint64_t chunk = layout.chunk_of(facet.ranks[0]);
    out.add(ExportKind::kFacets, chunk, facet);
    for (int i = 1; i < 3; ++i) {
      const std::uint64_t owner = layout.chunk_of(facet.ranks[i]);
      if (owner != chunk) {
        out.add(ExportKind::kBorderPoints, owner, BorderPoint{facet.ranks[i], chunk});
      }
    }
    const std::uint64_t far_side = layout.chunk_of(facet.ranks[1]);
    if (far_side != chunk) {
      out.add(ExportKind::kBorderEdges, far_side, BorderEdge{facet.ranks[1], facet.ranks[2]});
    }
  }
}

}  // namespace stream_recon
