#include "engine/reconstruct.h"

#include <fmt/format.h>

#include "engine/parallel.h"
#include "engine/pipeline.h"
#include "engine/process_memory.h"
#include "engine/run_checks.h"
#include "engine/size_text.h"
#include "engine/stage_context.h"
#include "engine/version.h"
#include "spatial/simplex_digest.h"

namespace stream_recon {
namespace {

/// The process before and beside all reservations: code, libraries, stacks, small blocks (measured:
/// docs/benchmarks.md), and a share for each thread.
constexpr std::uint64_t kProcessBytes = std::uint64_t{20} << 20;
constexpr std::uint64_t kThreadBytes = std::uint64_t{1} << 18;

std::uint64_t memory_limit(const RunOptions& options) {
  const std::uint64_t limit =
      options.memory_bytes != 0 ? options.memory_bytes : physical_memory_bytes() / 2;
  if (limit < kLeastMemory) {
    throw BudgetError(
        fmt::format("--memory {} is too little for any cloud; give --memory {} or more",
                    size_argument(limit), size_argument(kLeastMemory)));
  }
  return limit;
}

const char* kind_name(SurfaceKind kind) {
  switch (kind) {
    case SurfaceKind::kGamma:
      return "gamma";
    case SurfaceKind::kAlpha:
      return "alpha";
    case SurfaceKind::kNone:
      break;
  }
  return "none";
}

}  // namespace

Report reconstruct(const RunOptions& options) {
  check_options(options);
  make_allocator_return_memory();
  const unsigned threads = options.threads != 0 ? options.threads : default_threads();
  const ThreadLimit thread_limit(threads);
  MemoryBudget budget(memory_limit(options));
  const Reservation process =
      budget.reserve(kProcessBytes + threads * kThreadBytes, "the process itself");
  const std::string& main_output = options.output.empty() ? options.tetrahedra : options.output;
  ScratchDirectory scratch(
      {options.scratch.empty() ? default_scratch_parent(main_output) : options.scratch,
       options.scratch_limit_bytes});
  Progress progress(options.progress);
  const StopRequest never;
  const StageContext context{scratch, budget, progress,
                             options.stop != nullptr ? *options.stop : never};

  Report report;
  report.version = version();
  report.threads = threads;
  report.memory_budget_bytes = budget.limit();
  report.surface.kind = kind_name(options.surface);
  report.surface.digest = SimplexDigest().hex();
  run_pipeline(options, context, report);
  report.scratch_peak_bytes = scratch.peak_bytes();
  report.peak_rss_bytes = peak_resident_bytes();
  return report;
}

}  // namespace stream_recon
