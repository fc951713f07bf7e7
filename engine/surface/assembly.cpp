#include "engine/surface/assembly.h"

#include <mutex>
#include <optional>

#include "engine/chunks/chunk_loop.h"
#include "engine/chunks/chunk_numbers.h"
#include "engine/surface/chunk_surface.h"
#include "engine/surface/piece_join.h"
#include "engine/surface/surface_sheets.h"
#include "engine/surface/vertex_numbering.h"

namespace stream_recon {
namespace {

class SurfaceAssembly {
 public:
  SurfaceAssembly(const ExportedFacets& surface, SurfaceWriter& writer, const StageContext& context,
                  const AssemblyOptions& options)
      : surface_(surface),
        writer_(writer),
        context_(context),
        options_(options),
        numbers_(surface.facets(), surface.layout().chunk_count(), context.budget),
        join_({surface.layout(), options.is_solid}, context) {}

  SurfaceFacts run() {
    const bool is_ordered = writer_.takes_chunks_in_order();
    std::optional<SurfaceSheets> sheets;
    if (options_.splits) sheets.emplace(surface_, context_);
    std::optional<VertexNumbering> numbering;
    if (is_ordered) numbering.emplace(surface_, pointer_to(sheets), context_);
    const ChunkSurfaceMaker maker({.surface = surface_,
                                   .numbering = pointer_to(numbering),
                                   .sheets = pointer_to(sheets),
                                   .options = options_},
                                  context_);
    context_.progress.begin_stage("surface", surface_.layout().point_count, "points");
    const std::uint64_t bytes = maker.typical_memory(numbers_.most_records());
    for_each_chunk(
        {.chunks = surface_.layout().chunk_count(),
         .at_once = chunks_at_once(bytes, context_.budget),
         .takes_in_order = is_ordered},
        [&maker](std::uint64_t chunk) { return maker.make(chunk); },
        [this](std::uint64_t chunk, ChunkSurface made) { take(chunk, made); });
    context_.progress.end_stage();
    SurfaceFacts result = facts(join_.finish());
    if (sheets) sheets->correct(result.counts);
    return result;
  }

 private:
  template <class Part>
  static const Part* pointer_to(const std::optional<Part>& part) {
    return part ? &*part : nullptr;
  }

  void take(std::uint64_t chunk, const ChunkSurface& made) {
    {
      const std::lock_guard lock(mutex_);
      counts_.merge(made.counts);
      join_.add(chunk, made.pieces, made.sums);
    }
    if (options_.unused != nullptr) options_.unused->write(chunk, made.unused);
    if (made.counts.triangles != 0) writer_.write(numbers_.number(chunk), made.chunk);
    context_.progress.advance(surface_.layout().points_in(chunk));
  }

  SurfaceFacts facts(const JoinedPieces& joined) const {
    const double scale = options_.range.scale().value_or(1);
    SurfaceFacts facts{.counts = counts_,
                       .samples = counts_.vertices,
                       .components = joined.components,
                       .cavities = joined.cavities,
                       .area = joined.area.value() / scale / scale,
                       .volume = {},
                       .genus = {}};
    if (!options_.is_solid || counts_.unpaired_uses != 0) return facts;
    facts.volume = joined.six_volumes.value() / 6 / scale / scale / scale;
    // Where each two triangles of a wedge are joined, the surface is a manifold with a vertex for
    // each fan and an edge for two triangles; its Euler number is twice components less genus.
    const auto sheets = static_cast<std::int64_t>(joined.components + joined.cavities);
    const auto euler =
        static_cast<std::int64_t>(counts_.fans) - static_cast<std::int64_t>(counts_.triangles / 2);
    facts.genus = sheets - euler / 2;
    return facts;
  }

  const ExportedFacets& surface_;
  SurfaceWriter& writer_;
  const StageContext& context_;
  const AssemblyOptions& options_;
  ChunkNumbers numbers_;
  PieceJoin join_;
  std::mutex mutex_;
  SurfaceCounts counts_;
};

}  // namespace

SurfaceFacts assemble_surface(const ExportedFacets& surface, SurfaceWriter& writer,
                              const StageContext& context, const AssemblyOptions& options) {
  return SurfaceAssembly(surface, writer, context, options).run();
}

}  // namespace stream_recon
