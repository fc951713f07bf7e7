#include "engine/windows/window_stage.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <mutex>
#include <utility>
#include <vector>

#include "engine/parallel.h"
#include "engine/size_text.h"
#include "engine/windows/export_writer.h"
#include "engine/windows/window_plan.h"

namespace stream_recon {
namespace {

using namespace index_layout;

class WindowStage {
 public:
  WindowStage(const WindowStageParts& parts, WindowProgress progress, const WindowPlan& plan,
              const StageContext& context)
      : parts_(parts),
        plan_(plan),
        context_(context),
        memory_(context.budget.reserve(
            plan.cache_bytes + plan.threads * (plan.window_bytes + plan.fixed_bytes),
            "the windows")),
        caches_(context.scratch, parts.index, plan.cache_bytes),
        progress_(std::move(progress)),
        open_(progress_.open_ranges(parts.index.point_count)),
        window_points_(plan.window_points),
        left_points_(parts.index.point_count - progress_.done_points()) {}

  WindowProgress run() {
    context_.progress.begin_stage("delaunay", parts_.index.point_count, "points");
    context_.progress.advance(progress_.done_points());
    parallel_for_ranges(plan_.threads, 1, [this](std::size_t begin, std::size_t end) {
      for (std::size_t worker = begin; worker < end; ++worker) work();
    });
    context_.progress.end_stage();
    return std::move(progress_);
  }

 private:
  using Clock = std::chrono::steady_clock;

  /// One worker: windows in the order of the curve until none is left.
  void work() {
    IndexReader reader(caches_);
    CertifiedWindow window(parts_.index, reader, context_, {plan_.whole_stars});
    for (;;) {
      const OwnedRange owned = next_range();
      if (owned.count == 0) return;
      build_and_consume(window, owned);
    }
  }

  OwnedRange next_range() {
    const std::lock_guard lock(mutex_);
    if (next_open_ == open_.size()) return {};
    OwnedRange& open = open_[next_open_];
    const OwnedRange owned{open.first, std::min(next_size(), open.count)};
    left_points_ -= owned.count;
    ++handed_out_;
    open.first += owned.count;
    open.count -= owned.count;
    if (open.count == 0) ++next_open_;
    return owned;
  }

  /// Such that all windows left are of one size and every thread gets as many.
  std::uint64_t next_size() const {
    const std::uint64_t needed = handed_out_ + quotient_up(left_points_, window_points_);
    const std::uint64_t windows = quotient_up(needed, plan_.threads) * plan_.threads - handed_out_;
    const std::uint64_t evenly = quotient_up(left_points_, windows);
    return std::min(window_points_, quotient_up(evenly, plan_.step) * plan_.step);
  }

  void build_and_consume(CertifiedWindow& window, const OwnedRange& owned) {
    const Clock::time_point began = Clock::now();
    if (window.build(owned, plan_.build_bytes) == CertifiedWindow::Outcome::kOutgrown) {
      split(window, owned, window.bytes());
      return;
    }
    const FinalWindow view = window.view();
    const std::uint64_t bytes = window.bytes() + consumer_memory(view);
    if (bytes > plan_.window_bytes) {
      split(window, owned, bytes);
      return;
    }
    const TetrahedraCensus census = take_census(view);
    ExportWriter out(context_.scratch, owned.first);
    for (WindowConsumer* consumer : parts_.consumers) consumer->consume(view, out);
    const WindowCounts counts = window.counts();
    window.clear();
    const std::uint64_t records = out.finish();
    finish(owned, {.windows = 1,
                   .counts = counts,
                   .tetrahedra = census,
                   .export_files = records != 0 ? 1U : 0U,
                   .export_records = records});
    expect(owned.count, Clock::now() - began);
  }

  void finish(const OwnedRange& owned, const WindowTotals& totals) {
    const std::lock_guard lock(mutex_);
    progress_.totals.add(totals);
    progress_.add_range(owned);
    if (parts_.observer) parts_.observer(progress_);
    context_.progress.advance(owned.count);
  }

  /// What is left, judged by what the windows of this run have cost so far.
  void expect(std::uint64_t points, Clock::duration cost) {
    const std::lock_guard lock(mutex_);
    cost_seconds_ += std::chrono::duration<double>(cost).count();
    cost_points_ += points;
    const auto left = static_cast<double>(parts_.index.point_count - progress_.done_points());
    context_.progress.expect(left * cost_seconds_ / static_cast<double>(cost_points_) /
                             plan_.threads);
  }

  /// One consumer comes after the other.
  std::uint64_t consumer_memory(const FinalWindow& view) const {
    std::uint64_t bytes = 0;
    for (const WindowConsumer* consumer : parts_.consumers) {
      bytes = std::max(bytes, consumer->memory(view));
    }
    return bytes;
  }

  /// \param bytes that the window needs at least
  void split(CertifiedWindow& window, const OwnedRange& owned, std::uint64_t bytes) {
    window.clear();
    if (owned.count <= kLeafPoints) refuse_star(owned, bytes);
    {
      const std::lock_guard lock(mutex_);
      ++progress_.totals.splits;
      // Those to come are likely to outgrow it as well, and a split costs a window; but a few large
      // stars must not make all of them small.
      if (owned.count >= window_points_) {
        const std::uint64_t fewer = std::max(owned.count * 7 / 8, plan_.window_points / 2);
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

  const WindowStageParts& parts_;
  const WindowPlan plan_;
  const StageContext& context_;
  Reservation memory_;
  IndexCaches caches_;
  std::mutex mutex_;  ///< guards what follows
  WindowProgress progress_;
  std::vector<OwnedRange> open_;
  std::size_t next_open_ = 0;
  std::uint64_t window_points_;  ///< of the windows to come, at most
  std::uint64_t left_points_;    ///< for them
  std::uint64_t handed_out_ = 0;
  double cost_seconds_ = 0;
  std::uint64_t cost_points_ = 0;
};

}  // namespace

WindowProgress run_window_stage(const WindowStageParts& parts, WindowProgress progress,
                                const WindowStageOptions& options, const StageContext& context) {
  if (progress.done_points() == parts.index.point_count) return progress;
  const WindowPlan plan = plan_windows(parts.index, options, context.budget);
  return WindowStage(parts, std::move(progress), plan, context).run();
}

}  // namespace stream_recon
