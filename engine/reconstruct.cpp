#include "engine/reconstruct.h"

#include <fmt/format.h>

#include "engine/parallel.h"
#include "engine/pipeline.h"
#include "engine/process_memory.h"
#include "engine/restart/open_run.h"
#include "engine/restart/run_identity.h"
#include "engine/restart/run_journal.h"
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

/// How to go on after an error that a later run may not meet.
std::string with_hint(const char* message, const ScratchDirectory& scratch) {
  return fmt::format("{}; what is done is kept in {}: add --resume to go on from there", message,
                     scratch.path());
}

/// Runs the stages; an error says how to resume where that is possible.
void run(const RunOptions& options, const StageContext& context, RunJournal& journal,
         Report& report) {
  try {
    run_pipeline(options, context, journal, report);
    journal.close();
  } catch (const InputError&) {
    journal.close();
    throw;
  } catch (const std::invalid_argument&) {
    journal.close();
    throw;
  } catch (const IoError& e) {
    if (!journal.is_resumable()) throw;
    throw IoError(with_hint(e.what(), context.scratch));
  } catch (const BudgetError& e) {
    if (!journal.is_resumable()) throw;
    throw BudgetError(with_hint(e.what(), context.scratch));
  } catch (const Interrupted&) {
    throw Interrupted(journal.is_resumable());
  }
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
  const OpenedRun opened = open_run(options, identity_of(options));
  ScratchDirectory& scratch = *opened.scratch;
  Progress progress(options.progress);
  StopRequest never;
  StopRequest& stop = options.stop != nullptr ? *options.stop : never;
  RunJournal journal(scratch, opened.manifest, stop);
  const StageContext context{scratch, budget, progress, stop};

  Report report;
  report.version = version();
  report.threads = threads;
  report.memory_budget_bytes = budget.limit();
  report.surface.kind = kind_name(options.surface);
  report.surface.digest = SimplexDigest().hex();
  run(options, context, journal, report);
  report.scratch_peak_bytes = scratch.peak_bytes();
  report.peak_rss_bytes = peak_resident_bytes();
  return report;
}

const char* kind_name(SurfaceKind kind) {
  switch (kind) {
    case SurfaceKind::kGamma:
      return "gamma";
    case SurfaceKind::kAlpha:
      return "alpha";
    case SurfaceKind::kSolid:
      return "solid";
    case SurfaceKind::kCrust:
      return "crust";
    case SurfaceKind::kHybrid:
      return "hybrid";
    case SurfaceKind::kNone:
      break;
  }
  return "none";
}

std::string RunOptions::scratch_parent() const {
  if (!scratch.empty()) return scratch;
  for (const std::string& path : {output, tetrahedra, medial_axis}) {
    if (!path.empty()) return default_scratch_parent(path);
  }
  return default_scratch_parent("");
}

}  // namespace stream_recon
