#include "engine/windows/window_plan.h"

#include <fmt/format.h>

#include <algorithm>

#include "engine/size_text.h"
#include "engine/windows/certified_window.h"
#include "engine/windows/export_writer.h"

namespace stream_recon {
namespace {

using namespace index_layout;

/// What a window is expected to need for each point it owns, guests included; where that is too
/// little it is split.
constexpr std::uint64_t kBytesAnOwnedPoint = 700;
constexpr std::uint64_t kBytesAWholeStar = 900;

/// Windows below this size are mostly guests: rather fewer threads.
constexpr std::uint64_t kSmallWindow = std::uint64_t{24} << 20;

/// Enough windows that no thread waits long for the last one.
constexpr std::uint64_t kWindowsAThread = 2;
constexpr std::uint64_t kLeastOwned = 1 << 15;

/// What a thread needs besides its window.
std::uint64_t fixed_memory(const CloudIndex& index) {
  return CertifiedWindow::fixed_memory(index) + ExportWriter::memory();
}

[[noreturn]] void refuse(std::uint64_t need, const MemoryBudget& budget) {
  throw BudgetError(
      fmt::format("--memory {} leaves {} for windows, but they need {}; give --memory {} or more",
                  size_argument(budget.limit()), size_text(budget.available()), size_text(need),
                  size_argument(budget.used() + need)));
}

}  // namespace

WindowPlan plan_windows(const CloudIndex& index, const WindowStageOptions& options,
                        const MemoryBudget& budget) {
  const std::uint64_t available = budget.available();
  const std::uint64_t fixed = fixed_memory(index);
  WindowPlan plan;
  plan.fixed_bytes = fixed;
  plan.whole_stars = options.whole_stars;
  const std::uint64_t least = IndexCaches::least_memory(1) + fixed + (std::uint64_t{4} << 20);
  if (available < least) refuse(least, budget);
  plan.cache_bytes = std::clamp(available / 12, IndexCaches::least_memory(options.threads),
                                std::max(IndexCaches::least_memory(options.threads),
                                         IndexCaches::most_memory(index.point_count)));
  plan.cache_bytes = std::min(plan.cache_bytes, available / 2);
  const std::uint64_t rest = available - plan.cache_bytes;
  plan.threads = static_cast<unsigned>(
      std::clamp<std::uint64_t>(rest / (fixed + kSmallWindow), 1, options.threads));
  plan.window_bytes = rest / plan.threads - fixed;
  const std::uint64_t build_bytes_a_point =
      options.whole_stars ? kBytesAWholeStar : kBytesAnOwnedPoint;
  const std::uint64_t bytes_a_point = build_bytes_a_point + options.consumer_bytes_a_point;
  plan.build_bytes = plan.window_bytes / bytes_a_point * build_bytes_a_point;
  std::uint64_t points = plan.window_bytes / bytes_a_point;
  if (options.window_points != 0) points = std::min(points, options.window_points);
  const std::uint64_t evenly = quotient_up(index.point_count, kWindowsAThread * plan.threads);
  if (plan.threads > 1) points = std::min(points, std::max(evenly, kLeastOwned));
  // All windows of about the same size, and as many for every thread.
  std::uint64_t windows = quotient_up(index.point_count, std::max(points, kLeafPoints));
  if (windows > 1) windows = quotient_up(windows, plan.threads) * plan.threads;
  points = quotient_up(index.point_count, windows);
  // Whole pages make the index know at once what is in the window.
  plan.step = points >= 4 * kPagePoints ? kPagePoints : kLeafPoints;
  plan.window_points = quotient_up(points, plan.step) * plan.step;
  return plan;
}

}  // namespace stream_recon
