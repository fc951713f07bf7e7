#include "engine/crust/crust_windows.h"

#include <fmt/format.h>

#include <algorithm>
#include <mutex>
#include <span>
#include <utility>

#include "engine/crust/chosen_ranges.h"
#include "engine/crust/crust_faces.h"
#include "engine/parallel.h"
#include "engine/shape/shape_store.h"
#include "engine/size_text.h"
#include "engine/thread_clock.h"

namespace stream_recon {
namespace {

using namespace index_layout;

/// What a window is expected to need for each sample, faces included; where that is too little it
/// is split.
constexpr std::uint64_t kBytesASample = 3200;
constexpr std::uint64_t kLeastSamples = 1 << 13;
constexpr std::size_t kBlock = std::size_t{128} << 10;

struct Plan {
  unsigned threads;
  std::uint64_t cache_bytes;  ///< of the index
  std::uint64_t pole_pages;
  std::uint64_t fixed_bytes;   ///< each thread's, besides its window
  std::uint64_t window_bytes;  ///< each
  std::uint64_t window_points;
};

std::uint64_t points_of(const std::vector<OwnedRange>& ranges) {
  std::uint64_t points = 0;
  for (const OwnedRange& range : ranges) points += range.count;
  return points;
}

Plan plan_for(const CloudIndex& index, const std::vector<OwnedRange>& ranges,
              const CrustWindowOptions& options, const MemoryBudget& budget) {
  Plan plan{};
  const std::uint64_t available = budget.available();
  const std::uint64_t fixed =
      CertifiedWindow::fixed_memory(index) + PoleFinder::kMemory + 2 * record_file_memory(kBlock);
  const std::uint64_t least_cache = IndexCaches::least_memory(1);
  const std::uint64_t least = 2 * least_cache + fixed + (std::uint64_t{8} << 20);
  if (available < least) {
    throw BudgetError(fmt::format(
        "--memory {} leaves {} for the windows of the crust, but they need {}; give --memory {} or "
        "more",
        size_argument(budget.limit()), size_text(available), size_text(least),
        size_argument(budget.used() + least)));
  }
  plan.cache_bytes = std::clamp(available / 12, IndexCaches::least_memory(options.threads),
                                std::max(IndexCaches::least_memory(options.threads),
                                         IndexCaches::most_memory(index.point_count)));
  plan.cache_bytes = std::min(plan.cache_bytes, available / 4);
  plan.pole_pages = std::max<std::uint64_t>(2, available / 12 / PoleIndex::kPageMemory);
  const std::uint64_t rest =
      available - plan.cache_bytes - plan.pole_pages * PoleIndex::kPageMemory;
  plan.threads = static_cast<unsigned>(std::clamp<std::uint64_t>(
      rest / (fixed + kLeastSamples * kBytesASample), 1, options.threads));
  plan.fixed_bytes = fixed;
  plan.window_bytes = rest / plan.threads - fixed;
  std::uint64_t points = plan.window_bytes / kBytesASample;
  if (options.window_points != 0) points = std::min(points, options.window_points);
  points = std::max(points, kLeafPoints);
  const std::uint64_t all = points_of(ranges);
  std::uint64_t windows = std::max<std::uint64_t>(1, quotient_up(all, points));
  windows = quotient_up(windows, plan.threads) * plan.threads;
  plan.window_points = quotient_up(quotient_up(all, windows), kLeafPoints) * kLeafPoints;
  return plan;
}

class CrustFiles final : public CrustSink {
 public:
  CrustFiles(ScratchDirectory& scratch, const CrustWindow& window)
      : vertices_(create_records<CrustVertex>(scratch, window.vertices_file(), kBlock)),
        triangles_(create_records<CrustTriangle>(scratch, window.triangles_file(), kBlock)) {}

  void take_vertex(const CrustVertex& vertex) override { vertices_.append(vertex); }
  void take_face(std::span<const CrustTriangle> triangles) override {
    triangles_.append(triangles);
  }
  void finish() override {
    vertices_.finish();
    triangles_.finish();
  }

 private:
  RecordWriter<CrustVertex> vertices_;
  RecordWriter<CrustTriangle> triangles_;
};

class WindowLoop {
 public:
  WindowLoop(const CloudIndex& index, std::vector<OwnedRange> ranges,
             const CrustWindowOptions& options, const StageContext& context)
      : index_(index),
        ranges_(std::move(ranges)),
        options_(options),
        plan_(plan_for(index, ranges_, options, context.budget)),
        context_(context),
        memory_(context.budget.reserve(plan_.cache_bytes +
                                           plan_.pole_pages * PoleIndex::kPageMemory +
                                           plan_.threads * (plan_.fixed_bytes + plan_.window_bytes),
                                       "the windows of the crust")),
        poles_(context.scratch, plan_.pole_pages),
        caches_(context.scratch, index, plan_.cache_bytes) {}

  CrustWindows run() {
    context_.progress.begin_stage("crust", points_of(ranges_), "points");
    parallel_for_ranges(plan_.threads, 1, [this](std::size_t begin, std::size_t end) {
      for (std::size_t worker = begin; worker < end; ++worker) work();
    });
    context_.progress.end_stage();
    return std::move(result_);
  }

 private:
  void work() {
    IndexReader reader(caches_);
    PoleFinder finder(poles_);
    CertifiedWindow samples(index_, reader, context_, {.whole_stars = true});
    for (;;) {
      const OwnedRange owned = next_range();
      if (owned.count == 0) return;
      build(samples, finder, owned);
    }
  }

  OwnedRange next_range() {
    const std::lock_guard lock(mutex_);
    if (range_ == ranges_.size()) return {0, 0};
    OwnedRange& range = ranges_[range_];
    const OwnedRange owned{range.first, std::min(plan_.window_points, range.count)};
    range.first += owned.count;
    range.count -= owned.count;
    if (range.count == 0) ++range_;
    return owned;
  }

  void build(CertifiedWindow& samples, PoleFinder& finder, const OwnedRange& owned) {
    if (!try_build(samples, finder, owned)) {
      samples.clear();
      split(samples, finder, owned);
      return;
    }
    samples.clear();
    context_.progress.advance(owned.count);
  }

  bool try_build(CertifiedWindow& samples, PoleFinder& finder, const OwnedRange& owned) {
    using Outcome = CertifiedWindow::Outcome;
    PowerSeconds seconds;
    {
      const ThreadClock clock(seconds.samples);
      if (samples.build(owned, plan_.window_bytes) != Outcome::kDone) return false;
    }
    PowerWindow power(samples, poles_, finder);
    if (power.build(owned, plan_.window_bytes, options_.choice) != Outcome::kDone) return false;
    power.forget_walks();
    if (power.bytes() + faces_memory(power) > plan_.window_bytes) return false;
    {
      const ThreadClock clock(seconds.faces);
      if (options_.has_shape) write_shape(owned, shape_faces(power));
      const std::uint32_t number = reserve_number();
      if (options_.make_sink) {
        give_crust({number, options_.far_ranks}, *options_.make_sink(owned.first), power);
      } else if (options_.has_crust) {
        write_crust(number, owned, power);
      }
    }
    const std::lock_guard lock(mutex_);
    result_.power.counts.add(power.counts());
    result_.power.counts.seconds.add(seconds);
    return true;
  }

  std::uint64_t faces_memory(const PowerWindow& power) const {
    const std::uint64_t sink =
        power.poles().owned_count() * options_.sink_bytes_a_vertex * kCrustVerticesAPole;
    return std::max(options_.has_crust ? crust_faces_memory(power) + sink : 0,
                    options_.has_shape ? shape_faces_memory(power) : 0);
  }

  void write_shape(const OwnedRange& owned, const ShapeFaces& shape) {
    write_shape_window(context_.scratch, owned.first, shape.faces);
    const std::lock_guard lock(mutex_);
    result_.shape_windows.push_back(owned.first);
    result_.shape.add(shape.counts);
  }

  std::uint32_t reserve_number() {
    const std::lock_guard lock(mutex_);
    result_.windows.emplace_back();
    return static_cast<std::uint32_t>(result_.power.windows++);
  }

  void write_crust(std::uint32_t number, const OwnedRange& owned, const PowerWindow& power) {
    CrustWindow window{owned.first, 0};
    CrustFiles files(context_.scratch, window);
    window.vertices = give_crust({number, options_.far_ranks}, files, power);
    if (window.vertices == 0) {
      context_.scratch.remove(window.vertices_file());
      context_.scratch.remove(window.triangles_file());
    }
    const std::lock_guard lock(mutex_);
    result_.windows[number] = window;
  }

  /// The number of vertices.
  std::uint32_t give_crust(const CrustFacesOptions& options, CrustSink& sink,
                           const PowerWindow& power) {
    const CrustFacesCounts counts = write_crust_faces(power, options, sink);
    sink.finish();
    const std::lock_guard lock(mutex_);
    result_.faces += counts.faces;
    result_.power.unbounded += counts.unbounded;
    return counts.vertices;
  }

  void split(CertifiedWindow& samples, PoleFinder& finder, const OwnedRange& owned) {
    if (owned.count <= kLeafPoints) {
      throw BudgetError(fmt::format(
          "the balls around {} points need more than the {} that --memory {} leaves a window of "
          "the crust; give twice as much, or --threads 1",
          owned.count, size_text(plan_.window_bytes), size_argument(context_.budget.limit())));
    }
    {
      const std::lock_guard lock(mutex_);
      ++result_.splits;
    }
    const std::uint64_t half = quotient_up(owned.count / 2, kLeafPoints) * kLeafPoints;
    build(samples, finder, {owned.first, half});
    build(samples, finder, {owned.first + half, owned.count - half});
  }

  const CloudIndex& index_;
  std::vector<OwnedRange> ranges_;  ///< what is left of them
  const CrustWindowOptions& options_;
  const Plan plan_;
  const StageContext& context_;
  Reservation memory_;
  PoleIndex poles_;
  IndexCaches caches_;
  std::mutex mutex_;       ///< guards what follows
  std::size_t range_ = 0;  ///< the first that is not done
  CrustWindows result_;
};

}  // namespace

CrustWindows build_crust_windows(const CloudIndex& index, const CrustWindowOptions& options,
                                 const StageContext& context) {
  std::vector<OwnedRange> ranges{{0, index.point_count}};
  if (options.choice != nullptr) ranges = chosen_ranges(*options.choice, index, context);
  return WindowLoop(index, std::move(ranges), options, context).run();
}

}  // namespace stream_recon
