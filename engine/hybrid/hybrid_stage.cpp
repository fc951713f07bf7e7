#include "engine/hybrid/hybrid_stage.h"

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "engine/hybrid/hole_crust.h"
#include "engine/hybrid/hole_samples.h"
#include "engine/hybrid/hole_search.h"
#include "engine/hybrid/outer_facets.h"
#include "engine/hybrid/patch.h"
#include "engine/hybrid/patch_writer.h"
#include "engine/hybrid/stored_hole.h"
#include "engine/parallel.h"

namespace stream_recon {
namespace {

/// Holes that are made at a time hold about this much.
constexpr std::uint64_t kBatchBytes = std::uint64_t{4} << 20;
constexpr std::size_t kBatchHoles = 1 << 10;
/// Of a hole while its patch is made.
constexpr std::uint64_t kBytesACrustTriangle = 500;
/// Rings of up to so many edges, without a sample inside, are not worth a crust: six triangles
/// close the largest (measured: docs/decisions/0022-holes-of-the-hybrid.md).
constexpr std::size_t kSmallRing = 8;
/// Larger ones are no holes but shapes the gamma shape has nothing of; a fixed number, so that what
/// becomes of them does not depend on the memory.
constexpr std::size_t kMostFills = std::size_t{1} << 17;

class HybridStage {
 public:
  HybridStage(const CloudSummary& cloud, const HybridStageOptions& options,
              const StageContext& context)
      : cloud_(cloud),
        options_(options),
        context_(context),
        exports_{options.layout, {}},
        counts_(find_holes(context)) {}

  HybridResult run() {
    result_.report.holes = counts_.holes;
    HoleSamples samples(options_.layout.point_count, context_.budget);
    const Reservation memory = context_.budget.reserve(
        PatchWriter::memory() + HoleReader::memory() + 3 * kBatchBytes, "patches on their way");
    const Reservation marks = context_.budget.reserve(counts_.holes / 8, "holes without a patch");
    is_open_.resize(counts_.holes);
    close_by_triangles_all(samples);
    if (!samples.empty()) close_by_crust(samples);
    context_.scratch.remove(kHoleFills);
    context_.scratch.remove(kHolePoints);
    return result_;
  }

 private:
  /// No window begins at such a rank.
  PatchWriter make_writer(std::uint64_t number) const {
    return {exports_, options_.layout.point_count + number, context_};
  }

  void close_by_triangles_all(HoleSamples& samples) {
    PatchWriter out = make_writer(0);
    HoleReader reader(context_.scratch, false);
    while (const auto number = reader.next()) {
      if (*number % kBatchHoles == 0) context_.stop.check();
      const StoredHole stored = reader.read();
      std::optional<Patch> patch;
      if (stored.hole.fills.size() + 2 <= kSmallRing) patch = close_by_triangles(stored.hole);
      if (patch) {
        take(stored, *patch, out);
      } else if (stored.hole.fills.size() > kMostFills) {
        leave(stored, out);
      } else {
        is_open_[stored.number] = true;
        samples.add(stored.ranks, stored.number);
      }
    }
    samples.finish();
    out.finish();
  }

  void close_by_crust(const HoleSamples& samples) {
    const Reservation bits = context_.budget.reserve(
        SampleChoice::memory(options_.layout.point_count), "the samples beside holes");
    SampleChoice beside = samples.choice();
    store_outer_facets(samples, beside, context_);
    const HoleCrustOptions options{beside, options_.threads, options_.window_points};
    const HoleCrustResult crust =
        build_hole_crust(cloud_, options_.layout.point_count, samples, options, context_);
    result_.power = crust.power;
    {
      const Reservation memory = context_.budget.reserve(
          threads_in_use() * crust.most_triangles * kBytesACrustTriangle, "the largest holes");
      PatchWriter out = make_writer(1);
      HoleReader reader(context_.scratch, true);
      while (reader.next()) close_some(reader, out);
      out.finish();
    }
    context_.scratch.remove(kOuterFacets);
    context_.scratch.remove(kHoleCrust);
  }

  /// Those that are open among the next holes.
  void close_some(HoleReader& reader, PatchWriter& out) {
    context_.stop.check();
    std::vector<StoredHole> holes;
    std::uint64_t bytes = 0;
    while (bytes < kBatchBytes && holes.size() < kBatchHoles) {
      const auto number = reader.next();
      if (!number) break;
      if (is_open_[*number]) {
        holes.push_back(reader.read());
        bytes += holes.back().bytes();
      } else {
        reader.skip();
      }
    }
    std::vector<Patch> patches(holes.size());
    parallel_for_ranges(holes.size(), 1, [&](std::size_t begin, std::size_t end) {
      for (; begin < end; ++begin) {
        patches[begin] = make_patch(holes[begin].hole, holes[begin].crust);
      }
    });
    for (std::size_t i = 0; i < holes.size(); ++i) {
      if (patches[i].kind == PatchKind::kNone) {
        leave(holes[i], out);
      } else {
        take(holes[i], patches[i], out);
      }
    }
  }

  void take(const StoredHole& stored, const Patch& patch, PatchWriter& out) {
    HybridReport& report = result_.report;
    ++(patch.kind == PatchKind::kCrust ? report.by_crust : report.by_triangles);
    report.patch_triangles += patch.triangles.size();
    report.kept_fills += patch.kept_fills;
    report.unused_samples += patch.unused_samples;
    out.write(stored, patch.triangles);
  }

  void leave(const StoredHole& stored, PatchWriter& out) {
    ++(options_.fills_rest ? result_.report.by_solid : result_.report.left_out);
    if (options_.fills_rest) out.write_fills(stored);
  }

  const CloudSummary& cloud_;
  const HybridStageOptions& options_;
  const StageContext& context_;
  const SolidExportOptions exports_;
  const HoleCounts counts_;
  std::vector<bool> is_open_;  ///< holes that triangles alone do not close
  HybridResult result_;
};

}  // namespace

HybridResult build_hybrid(const CloudSummary& cloud, const HybridStageOptions& options,
                          const StageContext& context) {
  for (const std::string& name : context.scratch.names()) {
    if (name.starts_with("hole_") || name.starts_with("crust")) context.scratch.remove(name);
  }
  return HybridStage(cloud, options, context).run();
}

}  // namespace stream_recon
