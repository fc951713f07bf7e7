#include "engine/poles/medial_axis.h"

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/chunks/chunk_loop.h"
#include "engine/chunks/chunk_numbers.h"
#include "engine/order/point_store.h"
#include "engine/poles/pole_store.h"

namespace stream_recon {
namespace {

constexpr std::size_t kBatch = 1 << 10;

/// A block of an array, its compressed form, the compressor's tables; a point store's cursor.
constexpr std::uint64_t kFixedBytes = std::uint64_t{3} << 20;
/// A ball as it is written, and its sample's rank and coordinates on the way.
constexpr std::uint64_t kBallBytes = sizeof(Point3) + sizeof(double) + sizeof(float) + 1 +
                                     2 * sizeof(std::uint64_t) + sizeof(Point3);

constexpr const char* kHolder = "a chunk of the medial axis (a smaller --chunk-points needs less)";

/// How many poles each chunk has, which lie in the store one chunk after the other.
class PoleChunks {
 public:
  PoleChunks(std::uint64_t chunks, MemoryBudget& budget)
      : memory_(budget.reserve((chunks + 1) * sizeof(Chunk), "the chunks of the medial axis")),
        chunks_(chunks + 1) {}

  void add(std::uint64_t chunk, bool is_taken) {
    ++chunks_[chunk + 1].first;
    chunks_[chunk].taken += is_taken ? 1 : 0;
  }
  /// All are added.
  void finish() {
    for (std::size_t i = 1; i < chunks_.size(); ++i) chunks_[i].first += chunks_[i - 1].first;
  }

  std::uint64_t first(std::uint64_t chunk) const { return chunks_[chunk].first; }
  std::uint64_t end(std::uint64_t chunk) const { return chunks_[chunk + 1].first; }
  /// Of those that are taken.
  std::uint64_t count(std::uint64_t chunk) const { return chunks_[chunk].taken; }

 private:
  struct Chunk {
    std::uint64_t first = 0;  ///< until finish(): how many the chunk before has
    std::uint64_t taken = 0;
  };
  Reservation memory_;
  std::vector<Chunk> chunks_;
};

struct ChunkBalls {
  Reservation memory;
  MedialAxisChunk chunk;
};

class MedialAxis {
 public:
  MedialAxis(const MedialAxisOptions& options, MedialAxisWriter& writer,
             const StageContext& context)
      : options_(options),
        writer_(writer),
        context_(context),
        poles_(context.scratch.open(kPoleStore)),
        points_(context.scratch.open(kPointStore)),
        chunks_(options.layout.chunk_count(), context.budget) {}

  void run() {
    context_.progress.begin_stage("medial axis", options_.layout.point_count, "points");
    count();
    const ChunkNumbers numbers(chunks_, options_.layout.chunk_count(), context_.budget);
    const std::uint64_t bytes =
        numbers.most_records() * kBallBytes + kFixedBytes + PoleReader::memory();
    for_each_chunk(
        {.chunks = options_.layout.chunk_count(),
         .at_once = chunks_at_once(bytes, context_.budget)},
        [this](std::uint64_t chunk) { return make(chunk); },
        [&](std::uint64_t chunk, const ChunkBalls& made) {
          if (!made.chunk.centres.empty()) writer_.write(numbers.number(chunk), made.chunk);
          context_.progress.advance(options_.layout.points_in(chunk));
        });
    context_.progress.end_stage();
  }

 private:
  bool takes(const Pole& pole) const {
    return pole.is_inside != 0 ? options_.takes_inner : options_.takes_outer;
  }

  void count() {
    visit(0, poles_.record_count(), [this](const Pole& pole) {
      chunks_.add(options_.layout.chunk_of(pole.lowest_rank()), takes(pole));
    });
    chunks_.finish();
  }

  template <class Visit>
  void visit(std::uint64_t first, std::uint64_t end, const Visit& visit) const {
    PoleReader reader(poles_, context_.budget);
    reader.seek(first);
    std::vector<Pole> batch(kBatch);
    for (; first < end; first += batch.size()) {
      context_.stop.check();
      batch.resize(std::min<std::uint64_t>(end - first, kBatch));
      reader.read(batch);
      for (const Pole& pole : batch) visit(pole);
    }
  }

  ChunkBalls make(std::uint64_t chunk) const {
    ChunkBalls made;
    const std::uint64_t count = chunks_.count(chunk);
    if (count == 0) return made;
    made.memory = context_.budget.reserve(count * kBallBytes + kFixedBytes, kHolder);
    MedialAxisChunk& balls = made.chunk;
    balls.centres.reserve(count);
    balls.radius.reserve(count);
    balls.angle.reserve(count);
    balls.label.reserve(count);
    std::vector<PointRank> samples;
    samples.reserve(count);
    visit(chunks_.first(chunk), chunks_.end(chunk), [&](const Pole& pole) {
      if (!takes(pole)) return;
      balls.centres.push_back(pole.centre);
      balls.radius.push_back(pole.radius);
      balls.angle.push_back(pole.separation);
      balls.label.push_back(pole.is_inside);
      samples.push_back(pole.lowest_rank());
    });
    std::vector<Point3> points;
    read_points(points_, samples, points, balls.point_id);
    return made;
  }

  const MedialAxisOptions& options_;
  MedialAxisWriter& writer_;
  const StageContext& context_;
  const PoleFile poles_;
  const PointStoreFile points_;
  PoleChunks chunks_;
};

}  // namespace

void write_medial_axis(const MedialAxisOptions& options, MedialAxisWriter& writer,
                       const StageContext& context) {
  MedialAxis(options, writer, context).run();
}

}  // namespace stream_recon
