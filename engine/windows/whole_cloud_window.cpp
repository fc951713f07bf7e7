#include "engine/windows/whole_cloud_window.h"

#include <fmt/format.h>

#include <algorithm>
#include <span>
#include <string>

#include "engine/order/point_store.h"
#include "engine/process_memory.h"
#include "engine/size_text.h"
#include "io/error.h"

namespace stream_recon {
namespace {

constexpr std::size_t kBatch = 1 << 12;

// What a cloud is expected to need, to refuse early rather than after an hour: on surfaces and
// volumes there are 6 to 8.5 cells a point.
constexpr std::uint64_t kCellsAPoint = 9;
constexpr std::uint64_t kBytesACell = 32;
constexpr std::uint64_t kBytesAPoint = 25;
constexpr std::uint64_t kStructureBytes = kBytesAPoint + kCellsAPoint * kBytesACell;

/// The largest number of points whose ids leave room for the vertex at infinity.
constexpr std::uint64_t kMostPoints = Delaunay::kInfinite;

struct LoadedPoints {
  Reservation memory;
  std::vector<Point3> points;
};

void refuse_what_cannot_fit(std::uint64_t count, std::uint64_t kept_free,
                            const MemoryBudget& budget) {
  if (count > kMostPoints) {
    throw BudgetError(
        fmt::format("{} distinct points are more than one window can hold ({}); "
                    "split the cloud",
                    count, kMostPoints));
  }
  const std::uint64_t need =
      count * (kStructureBytes + sizeof(Point3) + sizeof(std::uint64_t)) + kept_free + (4 << 20);
  if (need <= budget.available()) return;
  throw BudgetError(
      fmt::format("the Delaunay structure of {} points needs about {}, but --memory {} leaves {}; "
                  "give --memory "
                  "{} or more, or fewer points",
                  count, size_text(need), size_argument(budget.limit()),
                  size_text(budget.available()), size_argument(budget.used() + need)));
}

[[noreturn]] void refuse_flat(std::uint64_t count, int dimension) {
  static constexpr const char* kShapes[] = {"at one place", "on one line", "in one plane"};
  const std::string lie =
      dimension < 0 ? std::string("there are none") : fmt::format("all lie {}", kShapes[dimension]);
  throw InputError(
      fmt::format("the input has {} distinct points and {}: a surface needs four that "
                  "are not in one plane; check the file and its --input-format",
                  count, lie));
}

[[noreturn]] void refuse_outgrown(std::uint64_t count, const Delaunay& delaunay,
                                  std::uint64_t granted, const MemoryBudget& budget) {
  throw BudgetError(
      fmt::format("the Delaunay structure of {} points outgrew the {} that --memory {} leaves it "
                  "(it reached {}); "
                  "give --memory {} or more",
                  count, size_text(granted), size_argument(budget.limit()),
                  size_text(delaunay.bytes()), size_argument(budget.limit() + granted / 2)));
}

}  // namespace

WholeCloudWindow::WholeCloudWindow(std::uint64_t point_count, std::uint64_t kept_free,
                                   const StageContext& context)
    : point_count_(point_count) {
  refuse_what_cannot_fit(point_count, kept_free, context.budget);
  context.progress.begin_stage("delaunay", point_count, "points");
  index_memory_ = context.budget.reserve(point_count * sizeof(std::uint64_t), "input indices");
  input_indices_.reserve(point_count);

  LoadedPoints loaded{
      context.budget.reserve(point_count * sizeof(Point3) + record_file_memory(kPointStoreBlock) +
                                 kBatch * sizeof(StoredPoint),
                             "points of the window"),
      {}};
  loaded.points.reserve(point_count);
  {
    PointStoreReader store(context.scratch, kPointStore);
    std::vector<StoredPoint> batch(kBatch);
    while (const std::size_t count = store.read(batch)) {
      context.stop.check();
      for (const StoredPoint& stored : std::span(batch).first(count)) {
        loaded.points.push_back(stored.point);
        input_indices_.push_back(stored.input_index);
      }
    }
  }

  const std::uint64_t granted = context.budget.available() - kept_free;
  structure_memory_ = context.budget.reserve(granted, "the Delaunay structure");
  delaunay_ = Delaunay(Delaunay::Options{.max_bytes = granted});
  switch (delaunay_.insert(loaded.points)) {
    case Delaunay::Outcome::kDone:
      break;
    case Delaunay::Outcome::kFlat:
      refuse_flat(point_count, delaunay_.dimension());
    case Delaunay::Outcome::kOutgrown:
      refuse_outgrown(point_count, delaunay_, granted, context.budget);
    case Delaunay::Outcome::kBadRange:
      throw InputError(
          "the coordinates are too far apart in magnitude for exact arithmetic: the "
          "largest is over 2^390 times the finest step; scale or clean the input");
  }
  context.stop.check();
  structure_memory_.resize(std::min<std::uint64_t>(granted, delaunay_.bytes()));
  context.progress.advance(point_count);
  context.progress.end_stage();
}

WholeCloudWindow::~WholeCloudWindow() {
  delaunay_ = Delaunay();
  input_indices_ = {};
  trim_allocator();
}

FinalWindow WholeCloudWindow::view() const {
  return FinalWindow({.delaunay = &delaunay_,
                      .first_rank = 0,
                      .owned_count = point_count_,
                      .guest_ranks = {},
                      .input_indices = input_indices_});
}

}  // namespace stream_recon
