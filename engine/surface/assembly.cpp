#include "engine/surface/assembly.h"

#include <mutex>
#include <optional>

#include "engine/chunks/chunk_loop.h"
#include "engine/chunks/chunk_numbers.h"
#include "engine/surface/chunk_surface.h"
#include "engine/surface/surface_sheets.h"
#include "engine/surface/vertex_numbering.h"

namespace stream_recon {
namespace {

class SurfaceAssembly {
 public:
  SurfaceAssembly(const ExportedFacets& surface, SurfaceWriter& writer, const StageContext& context)
      : surface_(surface),
        writer_(writer),
        context_(context),
        numbers_(surface.facets(), surface.layout().chunk_count(), context.budget) {}

  SurfaceCounts run(const AssemblyOptions& options) {
    const bool is_ordered = writer_.takes_chunks_in_order();
    std::optional<SurfaceSheets> sheets;
    if (options.splits) sheets.emplace(surface_, context_);
    std::optional<VertexNumbering> numbering;
    if (is_ordered) numbering.emplace(surface_, pointer_to(sheets), context_);
    const ChunkSurfaceMaker maker({surface_, pointer_to(numbering), pointer_to(sheets)}, context_);
    context_.progress.begin_stage("surface", surface_.layout().point_count, "points");
    const std::uint64_t bytes = ChunkSurfaceMaker::typical_memory(numbers_.most_records());
    for_each_chunk(
        {.chunks = surface_.layout().chunk_count(),
         .at_once = chunks_at_once(bytes, context_.budget),
         .takes_in_order = is_ordered},
        [&maker](std::uint64_t chunk) { return maker.make(chunk); },
        [this](std::uint64_t chunk, ChunkSurface made) { take(chunk, made); });
    context_.progress.end_stage();
    if (sheets) sheets->correct(counts_);
    return counts_;
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
    }
    if (made.counts.triangles != 0) writer_.write(numbers_.number(chunk), made.chunk);
    context_.progress.advance(surface_.layout().points_in(chunk));
  }

  const ExportedFacets& surface_;
  SurfaceWriter& writer_;
  const StageContext& context_;
  ChunkNumbers numbers_;
  std::mutex mutex_;
  SurfaceCounts counts_;
};

}  // namespace

SurfaceCounts assemble_surface(const ExportedFacets& surface, SurfaceWriter& writer,
                               const StageContext& context, const AssemblyOptions& options) {
  return SurfaceAssembly(surface, writer, context).run(options);
}

}  // namespace stream_recon
