#include "engine/surface/facet_export.h"

namespace stream_recon {
namespace {

/// The facet to its chunk, and its points to theirs.
void export_facet(const FacetRecord& facet, const ChunkLayout& layout, ExportWriter& out) {
  const std::uint64_t chunk = layout.chunk_of(facet.ranks[0]);
  out.add(ExportKind::kFacets, chunk, facet);
  for (int i = 1; i < 3; ++i) {
    const std::uint64_t owner = layout.chunk_of(facet.ranks[i]);
    if (owner != chunk) {
      out.add(ExportKind::kBorderPoints, owner, BorderPoint{facet.ranks[i], chunk});
    }
  }
}

bool is_left_out(const FacetRecord& facet, const std::optional<double>& open_ratio) {
  return open_ratio && facet.source == TriangleSource::kFill &&
         static_cast<double>(closure_of_code(facet.closure)) > *open_ratio;
}

}  // namespace

void export_facets(std::span<const FacetRecord> facets, const ChunkLayout& layout,
                   ExportWriter& out) {
  for (const FacetRecord& facet : facets) {
    export_facet(facet, layout, out);
    const std::uint64_t far_side = layout.chunk_of(facet.ranks[1]);
    if (far_side != layout.chunk_of(facet.ranks[0])) {
      out.add(ExportKind::kBorderEdges, far_side, BorderEdge{facet.ranks[1], facet.ranks[2]});
    }
  }
}

void export_solid_facets(std::span<const FacetRecord> facets, const SolidExportOptions& options,
                         ExportWriter& out) {
  const ChunkLayout& layout = options.layout;
  for (const FacetRecord& facet : facets) {
    if (is_left_out(facet, options.open_ratio)) continue;
    export_facet(facet, layout, out);
    std::uint64_t last = layout.chunk_of(facet.ranks[0]);
    for (int i = 1; i < 3; ++i) {
      const std::uint64_t owner = layout.chunk_of(facet.ranks[i]);
      if (owner != last) out.add(ExportKind::kBorderFacets, owner, facet);
      last = owner;
    }
  }
}

}  // namespace stream_recon
