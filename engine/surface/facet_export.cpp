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

void export_solid_facets(std::span<const FacetRecord> facets, const SolidExportOptions& options,
                         ExportWriter& out) {
  const ChunkLayout& layout = options.layout;
  export_facets(facets, layout, out);
  for (const FacetRecord& facet : facets) {
    std::uint64_t last = layout.chunk_of(facet.ranks[0]);
    for (int i = 1; i < 3; ++i) {
      const std::uint64_t owner = layout.chunk_of(facet.ranks[i]);
      if (owner != last) out.add(ExportKind::kBorderFacets, owner, facet);
      last = owner;
    }
  }
}

}  // namespace stream_recon
