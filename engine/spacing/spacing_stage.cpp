#include "engine/spacing/spacing_stage.h"

#include <algorithm>
#include <limits>
#include <vector>

#include "engine/chunks/chunk_loop.h"
#include "engine/parallel.h"
#include "engine/scratch_records.h"
#include "engine/spacing/neighbor_search.h"
#include "spatial/local_spacing.h"

namespace stream_recon {
namespace {

using namespace index_layout;

static_assert(kSpacingNeighbors == NeighborSearch::kMost);

/// Points measured in a row by one thread, a whole number of pages of the index.
constexpr std::uint64_t kChunkPoints = 8 * kPagePoints;

/// What a thread holds: its view of the index, and two chunks, one on its way to the file.
constexpr std::uint64_t kThreadMemory =
    IndexReader::kMemory + NeighborSearch::kMemory + 2 * kChunkPoints * sizeof(float);

float floor_of(const std::optional<SampleSpacing>& grid, double scale) {
  if (!grid) return 0;
  const double largest = *std::max_element(grid->begin(), grid->end()) * scale;
  return static_cast<float>(std::min(largest, double{std::numeric_limits<float>::max()}));
}

class SpacingStage {
 public:
  SpacingStage(const CloudIndex& index, const std::optional<SampleSpacing>& grid,
               const StageContext& context)
      : index_(index),
        context_(context),
        floor_(floor_of(grid, index.scale)),
        threads_(plan_threads()),
        cache_bytes_(plan_cache()),
        memory_(context.budget.reserve(
            record_file_memory(kSpacingBlock) + threads_ * kThreadMemory + cache_bytes_,
            "the spacing of the points")),
        caches_(context.scratch, index, cache_bytes_) {}

  void run() {
    context_.progress.begin_stage("spacing", index_.point_count, "points");
    auto writer = create_records<float>(context_.scratch, kSpacings, kSpacingBlock);
    const ChunkLoopOptions loop{.chunks = quotient_up(index_.point_count, kChunkPoints),
                                .at_once = threads_,
                                .takes_in_order = true};
    for_each_chunk(
        loop, [this](std::uint64_t chunk) { return measure(chunk * kChunkPoints); },
        [&writer](std::uint64_t, const std::vector<float>& spacings) { writer.append(spacings); });
    writer.finish();
    context_.progress.end_stage();
  }

 private:
  /// Those that half of the memory has room for.
  std::uint64_t plan_threads() const {
    return std::clamp<std::uint64_t>(context_.budget.available() / 2 / kThreadMemory, 1,
                                     threads_in_use());
  }

  std::uint64_t plan_cache() const {
    const std::uint64_t least = IndexCaches::least_memory(static_cast<unsigned>(threads_));
    const std::uint64_t most = std::max(least, IndexCaches::most_memory(index_.point_count));
    return std::clamp(context_.budget.available() / 4, least, most);
  }

  std::vector<float> measure(PointRank first) {
    IndexReader reader(caches_);
    NeighborSearch search(index_, reader);
    const PointRank end = std::min(first + kChunkPoints, index_.point_count);
    std::vector<float> spacings;
    spacings.reserve(end - first);
    for (PointRank page = first; page < end; page += kPagePoints) {
      context_.stop.check();
      const PointRank page_end = std::min(page + kPagePoints, end);
      for (PointRank rank = page; rank < page_end; rank += kLeafPoints) {
        search.search(leaf_of(rank));
        for (std::size_t i = 0; i < search.point_count(); ++i) {
          spacings.push_back(std::max(floor_, local_spacing(search.vectors(i))));
        }
      }
      context_.progress.advance(page_end - page);
    }
    return spacings;
  }

  const CloudIndex& index_;
  const StageContext& context_;
  const float floor_;
  const std::uint64_t threads_;
  const std::uint64_t cache_bytes_;
  Reservation memory_;
  IndexCaches caches_;
};

}  // namespace

void measure_spacing(const CloudIndex& index, const std::optional<SampleSpacing>& grid,
                     const StageContext& context) {
  SpacingStage(index, grid, context).run();
}

}  // namespace stream_recon
