#include "tools/check/mesh_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "engine/order/external_sort.h"
#include "engine/parallel.h"
#include "engine/process_memory.h"
#include "engine/size_text.h"
#include "engine/stage_context.h"
#include "io/mesh_source.h"
#include "tools/check/mesh_intake.h"
#include "tools/check/star_census.h"
#include "tools/check/vertex_copies.h"

namespace stream_recon {
namespace {

/// The process before and beside all reservations: code, libraries, stacks, small blocks, and a
/// share for each thread.
constexpr std::uint64_t kProcessBytes = std::uint64_t{12} << 20;
constexpr std::uint64_t kThreadBytes = std::uint64_t{1} << 18;
/// What grows with the mesh (labels, rings, components) gets this part of the free memory at least.
constexpr std::uint64_t kGrowingPart = 6;

std::uint64_t cache_bytes(const MeshCheckOptions& options) {
  return std::max<std::uint64_t>(options.memory_bytes / 16, std::uint64_t{2} << 20);
}

/// Shares what is free among the sorts.
struct SortMemory {
  std::uint64_t stars;
  std::uint64_t copies;

  SortMemory(const MemoryBudget& budget, bool has_copies) {
    constexpr std::uint64_t kLeast = ExternalSort<StarRecord>::least_memory();
    const std::uint64_t free = budget.available();
    const std::uint64_t sorting = free - free / kGrowingPart;
    copies = has_copies ? std::max(kLeast, sorting / 5) : 0;
    stars = std::max(kLeast, sorting - std::min(sorting, copies));
  }
};

MeshFacts check(const MeshCheckOptions& options, const StageContext& context) {
  MeshFacts facts;
  ComponentLabels labels(context.budget);
  const Reservation notes =
      context.budget.reserve(ComponentCensus::memory_bytes(), "the notes on components");
  ComponentCensus census(context);
  const auto source = open_mesh_source({options.path, &context.scratch, cache_bytes(options)});
  Reservation reading = context.budget.reserve(
      source->memory_bytes() + TriangleBatch::memory_bytes(), "the largest chunk of the mesh");
  const SortMemory sorting(context.budget, source->has_copies());
  ExternalSort<StarRecord> stars(context, {"stars", sorting.stars});
  VertexCopies copies(context, sorting.copies);
  {
    MeshIntake intake({options.path, context, labels, census, stars, copies, facts});
    source->read(intake);
    intake.finish();
  }
  reading.resize(0);
  const std::uint64_t points = copies.count(facts);
  count_stars(stars, {context, labels, census, facts});
  facts.unused_vertices = points - facts.vertices;
  census.finish(labels, facts);
  return facts;
}

}  // namespace

MeshFacts check_mesh(const MeshCheckOptions& options) {
  make_allocator_return_memory();
  const unsigned threads = options.threads != 0 ? options.threads : default_threads();
  const ThreadLimit thread_limit(threads);
  MemoryBudget budget(options.memory_bytes);
  const Reservation process =
      budget.reserve(kProcessBytes + threads * kThreadBytes, "the process itself");
  ScratchDirectory scratch(
      {.parent = options.scratch.empty() ? default_scratch_parent("-") : options.scratch});
  Progress progress(ProgressStyle::kNone);
  StopRequest never;
  return check(options,
               {scratch, budget, progress, options.stop != nullptr ? *options.stop : never});
}

}  // namespace stream_recon
