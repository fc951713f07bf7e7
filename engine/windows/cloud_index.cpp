#include "engine/windows/cloud_index.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <string>

#include "engine/order/point_store.h"
#include "engine/parallel.h"
#include "engine/parallel_records.h"
#include "io/error.h"
#include "spatial/predicates.h"

namespace stream_recon {
namespace {

using namespace index_layout;

constexpr std::size_t kPagesAtOnce = 32;
constexpr std::size_t kPageBytes = kPageNodes * sizeof(NodeBounds);

// A cloud spans at most 390 bits (spatial/coordinate_range.h): with its largest coordinate in this
// range the square of its least difference, and a rounding of that, are normal doubles; bounds are
// floats.
constexpr int kLeastMagnitude = -20;
constexpr int kMostMagnitude = 100;

[[noreturn]] void refuse_flat(std::uint64_t count, int dimension) {
  static constexpr const char* kShapes[] = {"at one place", "on one line", "in one plane"};
  const std::string lie =
      dimension < 0 ? std::string("there are none") : fmt::format("all lie {}", kShapes[dimension]);
  throw InputError(
      fmt::format("the input has {} distinct points and {}: a surface needs four that "
                  "are not in one plane; check the file and its --input-format",
                  count, lie));
}

double largest_coordinate(const Point3& p) {
  return std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)});
}

/// All nodes of one page, from its points relative to the origin.
void bound_page(std::span<const Point3> points, double reach, std::span<NodeBounds> nodes) {
  for (std::uint32_t node = 0; node < kPageNodes; ++node) {
    const LeafRange leaves = leaves_below(0, node);
    const std::size_t begin = std::min<std::size_t>(leaves.begin * kLeafPoints, points.size());
    const std::size_t end = std::min<std::size_t>(leaves.end * kLeafPoints, points.size());
    nodes[node] = bounds_of_points(points.subspan(begin, end - begin), reach);
  }
}

double scale_of(const CoordinateRange& range) {
  const bool is_usual = range.empty() || (range.magnitude_exponent >= kLeastMagnitude &&
                                          range.magnitude_exponent <= kMostMagnitude);
  return is_usual ? 1.0 : std::ldexp(1.0, std::clamp(-range.magnitude_exponent, -1023, 1023));
}

/// Four affinely independent points, found as the points go by.
class SimplexFinder {
 public:
  explicit SimplexFinder(const CoordinateRange& range)
      : scale_(range.scale().value()), exact_(range.times(scale_)) {}

  int dimension() const { return dimension_; }
  /// How many points were, up to the fourth.
  std::uint64_t offered() const { return offered_; }
  const std::array<PointRank, 4>& ranks() const { return ranks_; }

  void offer(const Point3& p, PointRank rank) {
    if (dimension_ == 3) return;
    ++offered_;
    corner_[dimension_ + 1] = {p.x * scale_, p.y * scale_, p.z * scale_};
    const auto& [a, b, c, d] = corner_;
    if (dimension_ == 1 && exact_.coplanar_orientation(a, b, c) == 0) return;
    if (dimension_ == 2 && exact_.orient3d(a, b, c, d) == 0) return;
    ranks_[++dimension_] = rank;
  }

 private:
  double scale_;
  Predicates exact_;
  int dimension_ = -1;
  std::uint64_t offered_ = 0;
  std::array<PointRank, 4> ranks_{};
  std::array<Point3, 4> corner_{};
};

class IndexBuilder {
 public:
  IndexBuilder(const CloudSummary& cloud, std::uint64_t point_count, const StageContext& context)
      : context_(context), samples_(cloud.points), finder_(cloud.range) {
    index_.point_count = point_count;
    index_.range = cloud.range;
    index_.scale = scale_of(cloud.range);
    const Box3 box{scaled(cloud.box.low), scaled(cloud.box.high)};
    index_.box = box;
    index_.origin = {box.low.x / 2 + box.high.x / 2, box.low.y / 2 + box.high.y / 2,
                     box.low.z / 2 + box.high.z / 2};
    index_.reach = 2 * std::max(largest_coordinate(box.low), largest_coordinate(box.high));
    const std::uint64_t pages = quotient_up(point_count, kPagePoints);
    index_.memory = context.budget.reserve(
        pages * (2 * sizeof(NodeBounds) + SphereShells::kBytesAPage), "the top of the index");
    index_.top.emplace_back().reserve(pages);
    index_.shells.pages.reserve(pages);
  }

  CloudIndex build() {
    write_pages();
    if (finder_.dimension() < 3) refuse_flat(finder_.offered(), finder_.dimension());
    index_.simplex = finder_.ranks();
    make_top();
    close_shells(index_.shells);
    return std::move(index_);
  }

 private:
  Point3 scaled(const Point3& p) const {
    return {p.x * index_.scale, p.y * index_.scale, p.z * index_.scale};
  }

  struct Batch {
    std::vector<StoredPoint> points = std::vector<StoredPoint>(kPagesAtOnce * kPagePoints);
    std::vector<Point3> relative = std::vector<Point3>(points.size());
    std::vector<NodeBounds> nodes = std::vector<NodeBounds>(kPagesAtOnce * kPageNodes);
    std::vector<std::optional<FoundShell>> shells =
        std::vector<std::optional<FoundShell>>(kPagesAtOnce);
    std::optional<Sphere> sphere;  ///< of the whole cloud, or of what is here
    std::size_t count = 0;

    std::size_t pages() const { return quotient_up(count, kPagePoints); }
  };
  static constexpr std::uint64_t kBatchMemory =
      kPagesAtOnce *
      (kPagePoints * (sizeof(StoredPoint) + sizeof(Point3)) + kPageNodes * sizeof(NodeBounds));

  /// Points of the whole cloud, evenly along the curve.
  std::optional<Sphere> sphere_of_cloud(const PointStoreFile& store) const {
    constexpr std::uint64_t kSamples = 64;
    RecordCursor<StoredPoint> cursor(store);
    std::vector<Point3> samples;
    for (std::uint64_t i = 0; i < kSamples; ++i) {
      StoredPoint stored;
      cursor.seek(i * index_.point_count / kSamples);
      if (cursor.read({&stored, 1}) == 1) samples.push_back(scaled(stored.point));
    }
    return shared_sphere(samples);
  }

  void write_pages() {
    const std::size_t readers = std::min<std::size_t>(threads_in_use(), kPagesAtOnce);
    const std::size_t blocks = blocks_at_once(kPageBytes, context_.budget);
    const Reservation memory =
        context_.budget.reserve(kBatchMemory + readers * record_cursor_memory(kPointStoreBlock) +
                                    blocks * record_file_memory(kPageBytes),
                                "the pages of the index");
    context_.progress.begin_stage("index", index_.point_count, "points");
    const PointStoreFile store(context_.scratch.open(kPointStore));
    auto writer = create_records<NodeBounds>(context_.scratch, kIndexPages, kPageBytes, blocks);
    Batch batch;
    const std::optional<Sphere> cloud_sphere = sphere_of_cloud(store);
    for (PointRank rank = 0; rank < index_.point_count; rank += batch.count) {
      context_.stop.check();
      batch.count = std::min<std::uint64_t>(batch.points.size(), index_.point_count - rank);
      batch.sphere = cloud_sphere;
      parallel_for_ranges(batch.pages(), 1, [&](std::size_t begin, std::size_t end) {
        RecordCursor<StoredPoint> cursor(store);
        cursor.seek(rank + begin * kPagePoints);
        for (std::size_t page = begin; page < end; ++page) bound(cursor, batch, page);
      });
      for (std::size_t i = 0; i < batch.count && finder_.dimension() < 3; ++i) {
        const StoredPoint& stored = batch.points[i];
        if (stored.input_index < samples_) finder_.offer(stored.point, rank + i);
      }
      for (std::size_t page = 0; page < batch.pages(); ++page) {
        index_.top[0].push_back(batch.nodes[page * kPageNodes]);
      }
      if (!cloud_sphere) share_sphere(batch);
      append_shells({batch.shells.data(), batch.pages()}, index_.shells);
      writer.append({batch.nodes.data(), batch.pages() * kPageNodes});
      context_.progress.advance(batch.count);
    }
    writer.finish();
    context_.progress.end_stage();
  }

  /// Reads and bounds one page.
  void bound(RecordCursor<StoredPoint>& store, Batch& batch, std::size_t page) const {
    const std::size_t first = page * kPagePoints;
    const std::size_t count = std::min<std::size_t>(kPagePoints, batch.count - first);
    store.read({&batch.points[first], count});
    const Point3& o = index_.origin;
    for (std::size_t i = first; i < first + count; ++i) {
      const Point3 p = scaled(batch.points[i].point);
      batch.relative[i] = {p.x - o.x, p.y - o.y, p.z - o.z};
    }
    bound_page({&batch.relative[first], count}, index_.reach,
               {&batch.nodes[page * kPageNodes], kPageNodes});
    find_page_shell(batch, page);
  }

  void find_page_shell(Batch& batch, std::size_t page) const {
    const std::size_t first = page * kPagePoints;
    std::vector<Point3> points;
    for (std::size_t i = first; i < std::min(first + kPagePoints, batch.count); ++i) {
      points.push_back(scaled(batch.points[i].point));
    }
    batch.shells[page] = find_shell(points, batch.sphere);
  }

  /// One sphere for the pages that have one of their own.
  void share_sphere(Batch& batch) const {
    std::vector<Point3> samples;
    std::size_t spheres = 0;
    for (std::size_t page = 0; page < batch.pages(); ++page) {
      if (!batch.shells[page]) continue;
      ++spheres;
      const std::size_t first = page * kPagePoints;
      const std::size_t end = std::min(first + kPagePoints, batch.count);
      for (std::size_t i = first; i < end; i += kPagePoints / 16) {
        samples.push_back(scaled(batch.points[i].point));
      }
    }
    if (spheres < 2) return;
    batch.sphere = shared_sphere(samples);
    if (!batch.sphere) return;
    parallel_for_ranges(batch.pages(), 1, [&](std::size_t begin, std::size_t end) {
      for (std::size_t page = begin; page < end; ++page) {
        if (batch.shells[page]) find_page_shell(batch, page);
      }
    });
  }

  void make_top() {
    while (index_.top.back().size() > 1) {
      const std::span<const NodeBounds> below = index_.top.back();
      std::vector<NodeBounds> level;
      level.reserve(quotient_up(below.size(), kFanout));
      for (std::size_t first = 0; first < below.size(); first += kFanout) {
        level.push_back(bounds_of_nodes(
            below.subspan(first, std::min<std::size_t>(kFanout, below.size() - first)),
            index_.reach));
      }
      index_.top.push_back(std::move(level));
    }
  }

  const StageContext& context_;
  const std::uint64_t samples_;  ///< input indices from here on are of far points
  SimplexFinder finder_;
  CloudIndex index_;
};

}  // namespace

CloudIndex build_index(const CloudSummary& cloud, std::uint64_t point_count,
                       const StageContext& context) {
  if (point_count == 0) refuse_flat(0, -1);
  if (!cloud.range.scale()) {
    throw InputError(
        "the coordinates are too far apart in magnitude for exact arithmetic: the "
        "largest is over 2^390 times the finest step; scale or clean the input");
  }
  return IndexBuilder(cloud, point_count, context).build();
}

}  // namespace stream_recon
