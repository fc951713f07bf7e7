#include "engine/surface/assembly.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "engine/order/point_store.h"
#include "engine/surface/chunk_facets.h"
#include "engine/surface/edge_census.h"
#include "engine/surface/orientation.h"
#include "engine/surface/vertex_numbering.h"

namespace stream_recon {
namespace {

// A facet's record, local triangle, three edges, and its share of the vertices and of the chunk;
// when the chunk is written, the writer's copies take the place of all but the chunk.
constexpr std::uint64_t kBytesATriangle = 140;

class SurfaceAssembly {
 public:
  SurfaceAssembly(const ExportedFacets& surface, SurfaceWriter& writer, const StageContext& context)
      : surface_(surface),
        writer_(writer),
        context_(context),
        store_memory_(
            context.budget.reserve(record_file_memory(kPointStoreBlock), "the point store")),
        store_(context.scratch, kPointStore),
        numbering_(surface, context) {}

  SurfaceCounts run() {
    for (std::uint64_t chunk = 0; chunk < surface_.layout().chunk_count(); ++chunk) {
      context_.stop.check();
      assemble(chunk);
    }
    counts_.vertices = numbering_.vertex_count();
    counts_.edges = census_.edges();
    counts_.boundary_edges = census_.boundary();
    counts_.nonmanifold_edges = census_.nonmanifold();
    return counts_;
  }

 private:
  void assemble(std::uint64_t chunk) {
    const std::uint64_t count = surface_.facets().count(chunk);
    const std::uint64_t border_edges = surface_.border_edges().count(chunk);
    const Reservation memory = context_.budget.reserve(
        count * kBytesATriangle + border_edges * sizeof(BorderEdge),
        "assembling a chunk of the surface (a smaller --chunk-points needs less)");
    const SurfaceChunk result = make_chunk(chunk);
    if (count == 0) return;
    writer_.write(result);
    context_.progress.advance(count);
  }

  /// Counts the chunk's edges on the way; what it needed besides the result is gone on return.
  SurfaceChunk make_chunk(std::uint64_t chunk) {
    const ChunkFacets facets(surface_.facets().records(chunk));
    const auto uses = sorted_edge_uses(facets.triangles);
    take_census(chunk, facets, uses);
    SurfaceChunk result;
    result.vertex_numbers = numbering_.numbers_of(chunk, facets.vertices);
    gather_points(facets.vertices, result);
    add_triangles(facets, uses, result);
    return result;
  }

  void take_census(std::uint64_t chunk, const ChunkFacets& facets,
                   const std::vector<EdgeUse>& uses) {
    auto handed_over = surface_.border_edges().records(chunk);
    std::sort(handed_over.begin(), handed_over.end());
    census_.add({.uses = uses,
                 .ranks = facets.vertices,
                 .handed_over = handed_over,
                 .end = (chunk + 1) * surface_.layout().points_per_chunk});
    counts_.triangles += facets.triangles.size();
  }

  void gather_points(const std::vector<PointRank>& ranks, SurfaceChunk& result) {
    result.points.reserve(ranks.size());
    result.global_ids.reserve(ranks.size());
    for (const PointRank rank : ranks) {
      StoredPoint stored;
      store_.read_at(rank, {&stored, 1});
      result.points.push_back(stored.point);
      result.global_ids.push_back(stored.input_index);
    }
  }

  void add_triangles(const ChunkFacets& facets, const std::vector<EdgeUse>& uses,
                     SurfaceChunk& result) {
    std::vector<Facing> facing;
    facing.reserve(facets.facets.size());
    for (const FacetRecord& facet : facets.facets) facing.push_back(facet.facing);
    const std::vector<bool> reversed = reversals(uses, facing);

    result.triangles.reserve(facets.facets.size());
    result.delta.reserve(facets.facets.size());
    result.source.reserve(facets.facets.size());
    for (std::size_t t = 0; t < facets.facets.size(); ++t) {
      LocalTriangle v = facets.triangles[t];
      counts_.digest.add<3>(
          {result.global_ids[v[0]], result.global_ids[v[1]], result.global_ids[v[2]]});
      if (reversed[t]) std::swap(v[1], v[2]);
      result.triangles.push_back(v);
      result.delta.push_back(facets.facets[t].delta);
      result.source.push_back(facets.facets[t].source);
    }
  }

  const ExportedFacets& surface_;
  SurfaceWriter& writer_;
  const StageContext& context_;
  Reservation store_memory_;
  PointStoreReader store_;
  VertexNumbering numbering_;
  EdgeCensus census_;
  SurfaceCounts counts_;
};

}  // namespace

SurfaceCounts assemble_surface(const ExportedFacets& surface, SurfaceWriter& writer,
                               const StageContext& context) {
  return SurfaceAssembly(surface, writer, context).run();
}

}  // namespace stream_recon
