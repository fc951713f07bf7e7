#include "engine/windows/window_stage.h"

#include <fmt/format.h>

#include <algorithm>
#include <mutex>
#include <vector>

#include "engine/parallel.h"
#include "engine/process_memory.h"
#include "engine/size_text.h"

namespace stream_recon {
namespace {

using namespace index_layout;

/// What a window is expected to need for each point it owns, guests included; where that is too
/// little it is split.
constexpr std::uint64_t kBytesAnOwnedPoint = 700;

/// Windows below this size are mostly guests: rather fewer threads.
constexpr std::uint64_t kSmallWindow = std::uint64_t{24} << 20;

/// Enough windows that no thread waits long for the last one.
constexpr std::uint64_t kWindowsAThread = 2;
constexpr std::uint64_t kLeastOwned = 1 << 15;

/// How the memory is shared out.
struct Plan {
  unsigned threads = 1;
  std::uint64_t cache_bytes = 0;
  std::uint64_t window_bytes = 0;  ///< each
  std::uint64_t window_points = 0;
};

[[noreturn]] void refuse(std::uint64_t need, const MemoryBudget& budget) {
  throw BudgetError(
      fmt::format("--memory {} leaves {} for windows, but they need {}; give --memory {} or more",
                  size_argument(budget.limit()), size_text(budget.available()), size_text(need),
                  size_argument(budget.used() + need)));
}

Plan make_plan(const CloudIndex& index, const WindowStageOptions& options,
               const MemoryBudget& budget) {
  const std::uint64_t available = budget.available();
  const std::uint64_t fixed = CertifiedWindow::fixed_memory(index);
  Plan plan;
  const std::uint64_t least = IndexCaches::least_memory(1) + fixed + (std::uint64_t{4} << 20);
  if (available < least) refuse(least, budget);
  plan.cache_bytes = std::clamp(available / 5, IndexCaches::least_memory(options.threads),
                                std::max(IndexCaches::least_memory(options.threads),
                                         IndexCaches::most_memory(index.point_count)));
  plan.cache_bytes = std::min(plan.cache_bytes, available / 2);
  const std::uint64_t rest = available - plan.cache_bytes;
  plan.threads = static_cast<unsigned>(
      std::clamp<std::uint64_t>(rest / (fixed + kSmallWindow), 1, options.threads));
  plan.window_bytes = rest / plan.threads - fixed;
  std::uint64_t points = plan.window_bytes / kBytesAnOwnedPoint;
  if (options.window_points != 0) points = std::min(points, options.window_points);
  const std::uint64_t evenly = quotient_up(index.point_count, kWindowsAThread * plan.threads);
  if (plan.threads > 1) points = std::min(points, std::max(evenly, kLeastOwned));
  // All windows of about the same size, and as many for every thread.
  std::uint64_t windows = quotient_up(index.point_count, std::max(points, kLeafPoints));
  if (windows > 1) windows = quotient_up(windows, plan.threads) * plan.threads;
  points = quotient_up(index.point_count, windows);
  // Whole pages make the index know at once what is in the window.
  const std::uint64_t step = points >= 4 * kPagePoints ? kPagePoints : kLeafPoints;
  plan.window_points = quotient_up(points, step) * step;
  return plan;
}

class WindowStage {
 public:
  WindowStage(const CloudIndex& index, std::span<WindowConsumer* const> consumers, const Plan& plan,
              const StageContext& context)
      : index_(index),
        consumers_(consumers),
        plan_(plan),
        context_(context),
        memory_(context.budget.reserve(
            plan.cache_bytes +
                plan.threads * (plan.window_bytes + CertifiedWindow::fixed_memory(index)),
            "the windows")),
        caches_(context.scratch, index, plan.cache_bytes),
        window_points_(plan.window_points) {}

  WindowStageResult run() {
    context_.progress.begin_stage("delaunay", index_.point_count, "points");
    parallel_for_ranges(plan_.threads, 1, [this](std::size_t begin, std::size_t end) {
      for (std::size_t worker = begin; worker < end; ++worker) work();
    });
    context_.progress.end_stage();
    return result_;
  }

 private:
  /// One worker: windows in the order of the curve until none is left.
  void work() {
    IndexReader reader(caches_);
    CertifiedWindow window(index_, reader, context_.stop);
    for (;;) {
      const OwnedRange owned = next_range();
      if (owned.count == 0) return;
      build_and_consume(window, owned);
    }
  }

  OwnedRange next_range() {
    const std::lock_guard lock(mutex_);
    const std::uint64_t count = std::min(window_points_, index_.point_count - next_);
    const OwnedRange owned{next_, count};
    next_ += count;
    return owned;
  }

  void build_and_consume(CertifiedWindow& window, const OwnedRange& owned) {
    if (window.build(owned, plan_.window_bytes) == CertifiedWindow::Outcome::kOutgrown) {
      split(window, owned);
      return;
    }
    for (WindowConsumer* consumer : consumers_) consumer->consume(window.view());
    {
      const std::lock_guard lock(mutex_);
      ++result_.windows;
      result_.counts.add(window.counts());
    }
    window.clear();
    context_.progress.advance(owned.count);
  }

  void split(CertifiedWindow& window, const OwnedRange& owned) {
    const std::uint64_t bytes = window.bytes();
    window.clear();
    if (owned.count <= kLeafPoints) refuse_star(owned, bytes);
    {
      const std::lock_guard lock(mutex_);
      ++result_.splits;
      // Those to come are likely to outgrow it as well, and a split costs a window; but a few large
      // stars must not make all of them small.
      if (owned.count >= window_points_) {
        const std::uint64_t fewer = std::max(owned.count * 3 / 4, plan_.window_points / 2);
        window_points_ = quotient_up(fewer, kLeafPoints) * kLeafPoints;
      }
    }
    const std::uint64_t half = quotient_up(owned.count / 2, kLeafPoints) * kLeafPoints;
    build_and_consume(window, {owned.first, half});
    build_and_consume(window, {owned.first + half, owned.count - half});
  }

  [[noreturn]] void refuse_star(const OwnedRange& owned, std::uint64_t bytes) const {
    const std::uint64_t used = context_.budget.limit() - plan_.window_bytes;
    throw BudgetError(fmt::format(
        "the tetrahedra around {} points need more than the {} that --memory {} leaves a window "
        "(it reached {}); give --memory {} or more, or --threads 1",
        owned.count, size_text(plan_.window_bytes), size_argument(context_.budget.limit()),
        size_text(bytes), size_argument(used + 2 * plan_.window_bytes)));
  }

  const CloudIndex& index_;
  std::span<WindowConsumer* const> consumers_;
  const Plan plan_;
  const StageContext& context_;
  Reservation memory_;
  IndexCaches caches_;
  std::mutex mutex_;
  PointRank next_ = 0;
  std::uint64_t window_points_;  ///< of the windows to come
  WindowStageResult result_;
};

}  // namespace

WindowStageResult run_window_stage(const CloudIndex& index,
                                   std::span<WindowConsumer* const> consumers,
                                   const WindowStageOptions& options, const StageContext& context) {
  const Plan plan = make_plan(index, options, context.budget);
  return WindowStage(index, consumers, plan, context).run();
}

}  // namespace stream_recon
