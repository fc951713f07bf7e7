#include "engine/poles/medial_axis.h"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "engine/chunks/chunk_loop.h"
#include "engine/chunks/chunk_numbers.h"
#include "engine/chunks/chunk_vertices.h"
#include "engine/order/point_store.h"
#include "engine/poles/pole_chunks.h"
#include "engine/poles/pole_store.h"
#include "engine/shape/shape_chunks.h"

namespace stream_recon {
namespace {

constexpr std::size_t kBatch = 1 << 10;

/// A block of an array, its compressed form, the compressor's tables; a point store's cursor.
constexpr std::uint64_t kFixedBytes = std::uint64_t{3} << 20;
/// A ball as it is written, and its sample's rank and coordinates on the way.
constexpr std::uint64_t kBallBytes = sizeof(Point3) + sizeof(double) + sizeof(float) + 1 +
                                     2 * sizeof(std::uint64_t) + sizeof(Point3);

/// Faces that meet in a ball of a later chunk, about.
constexpr std::uint64_t kCornersALaterBall = 4;

constexpr const char* kHolder = "a chunk of the medial axis (a smaller --chunk-points needs less)";

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
    const std::uint64_t chunks = options_.layout.chunk_count();
    const ChunkNumbers numbers(chunks_, chunks, context_.budget);
    std::uint64_t bytes = 0;
    for (std::uint64_t chunk = 0; chunk < chunks; ++chunk) {
      bytes = std::max(bytes, expected_bytes(chunk));
    }
    for_each_chunk(
        {.chunks = chunks, .at_once = chunks_at_once(bytes, context_.budget)},
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
    visit(0, poles_.record_count(), [this](PoleNumber, const Pole& pole) {
      chunks_.add(options_.layout.chunk_of(pole.lowest_rank()), takes(pole));
    });
    chunks_.finish();
    if (options_.has_faces) shape_.emplace(chunks_.ends(), context_);
  }

  /// Calls visit(number, pole).
  template <class Visit>
  void visit(std::uint64_t first, std::uint64_t end, const Visit& visit) const {
    PoleReader reader(poles_, context_.budget);
    reader.seek(first);
    std::vector<Pole> batch(kBatch);
    while (first < end) {
      context_.stop.check();
      batch.resize(std::min<std::uint64_t>(end - first, kBatch));
      reader.read(batch);
      for (const Pole& pole : batch) visit(static_cast<PoleNumber>(first++), pole);
    }
  }

  std::uint64_t ball_bytes() const { return kBallBytes + (shape_ ? sizeof(std::uint64_t) : 0); }
  /// Without the balls of later chunks.
  std::uint64_t own_bytes(std::uint64_t chunk) const {
    const std::uint64_t faces = shape_ ? shape_->count(chunk) : 0;
    return chunks_.count(chunk) * ball_bytes() + faces * sizeof(ShapeFace) + kFixedBytes;
  }
  std::uint64_t expected_bytes(std::uint64_t chunk) const {
    const std::uint64_t own = own_bytes(chunk) + PoleReader::memory();
    if (!shape_) return own;
    return own + ShapeChunks::reading_memory() +
           shape_->later_corners(chunk) / kCornersALaterBall * ball_bytes();
  }

  ChunkBalls make(std::uint64_t chunk) const {
    ChunkBalls made;
    if (chunks_.count(chunk) == 0) return made;
    made.memory = context_.budget.reserve(own_bytes(chunk), kHolder);
    std::vector<PointRank> samples;
    reserve(chunks_.count(chunk), made.chunk, samples);
    visit(chunks_.first(chunk), chunks_.end(chunk), [&](PoleNumber number, const Pole& pole) {
      if (takes(pole)) add(number, pole, made.chunk, samples);
    });
    made.chunk.own_count = samples.size();
    if (shape_) add_faces(chunk, made, samples);
    std::vector<Point3> points;
    read_points(points_, samples, points, made.chunk.point_id);
    return made;
  }

  void reserve(std::uint64_t count, MedialAxisChunk& balls, std::vector<PointRank>& samples) const {
    balls.centres.reserve(count);
    balls.radius.reserve(count);
    balls.angle.reserve(count);
    balls.label.reserve(count);
    if (shape_) balls.pole_id.reserve(count);
    samples.reserve(count);
  }

  void add(PoleNumber number, const Pole& pole, MedialAxisChunk& balls,
           std::vector<PointRank>& samples) const {
    balls.centres.push_back(pole.centre);
    balls.radius.push_back(pole.radius);
    balls.angle.push_back(pole.separation);
    balls.label.push_back(pole.is_inside);
    if (shape_) balls.pole_id.push_back(number);
    samples.push_back(pole.lowest_rank());
  }

  void add_faces(std::uint64_t chunk, ChunkBalls& made, std::vector<PointRank>& samples) const {
    MedialAxisChunk& balls = made.chunk;
    ChunkVertices corners(chunks_.first(chunk), chunks_.end(chunk), context_.budget);
    for (const std::uint64_t number : balls.pole_id) corners.add(number);
    shape_->visit(chunk, [&](const ShapeFace& face) {
      for (const PoleNumber pole : face.poles) {
        if (pole != kNoPole) corners.add(pole);
      }
    });
    corners.number();
    made.memory.resize(made.memory.bytes() + (corners.size() - balls.own_count) * ball_bytes());
    reserve(corners.size(), balls, samples);
    PoleReader reader(poles_, context_.budget);
    corners.for_each([&](PointRank number) {
      if (number < chunks_.end(chunk)) return;
      Pole pole;
      reader.seek(number);
      reader.read(std::span(&pole, 1));
      add(static_cast<PoleNumber>(number), pole, balls, samples);
    });
    balls.edges.reserve(shape_->edges(chunk));
    balls.triangles.reserve(shape_->count(chunk) - shape_->edges(chunk));
    shape_->visit(chunk, [&](const ShapeFace& face) {
      const std::uint32_t a = corners.position(face.poles[0]);
      const std::uint32_t b = corners.position(face.poles[1]);
      if (face.is_edge()) {
        balls.edges.push_back({a, b});
      } else {
        balls.triangles.push_back({a, b, corners.position(face.poles[2])});
      }
    });
  }

  const MedialAxisOptions& options_;
  MedialAxisWriter& writer_;
  const StageContext& context_;
  const PoleFile poles_;
  const PointStoreFile points_;
  PoleChunks chunks_;
  std::optional<ShapeChunks> shape_;
};

}  // namespace

void write_medial_axis(const MedialAxisOptions& options, MedialAxisWriter& writer,
                       const StageContext& context) {
  MedialAxis(options, writer, context).run();
}

}  // namespace stream_recon
