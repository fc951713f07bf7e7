#include "engine/labels/facet_labels.h"

#include <algorithm>
#include <array>
#include <mutex>
#include <optional>
#include <span>
#include <vector>

#include "engine/chunks/chunk_loop.h"
#include "engine/labels/candidate_facet.h"
#include "engine/windows/export_writer.h"

namespace stream_recon {
namespace {

constexpr std::uint64_t kWindowMemory =
    ExportWriter::memory() + record_file_memory(kFillsBlock) + (std::uint64_t{1} << 20);

FacetRecord facet_of(const CandidateFacet& candidate, Facing facing) {
  return {.ranks = {candidate.ranks[0], candidate.ranks[1], candidate.ranks[2]},
          .delta = candidate.delta,
          .source = candidate.source,
          .facing = facing,
          .closure = candidate.closure};
}

class FacetLabels {
 public:
  FacetLabels(const ExportReader& windows, const WindowLabels& labels,
              const FacetLabelOptions& options, const StageContext& context)
      : windows_(windows), labels_(labels), options_(options), context_(context) {}

  FacetLabelCounts run() {
    const auto first_ranks = windows_.chunks(ExportKind::kCandidates);
    context_.progress.begin_stage("labels", first_ranks.size(), "windows");
    const std::uint64_t bytes = kWindowMemory + ExportReader::read_memory();
    for_each_chunk(
        {.chunks = first_ranks.size(),
         .at_once = chunks_at_once(bytes, context_.budget),
         .takes_in_order = false},
        [&](std::uint64_t i) { return label_window(first_ranks[i]); },
        [this](std::uint64_t, const FacetLabelCounts& counts) { take(counts); });
    context_.progress.end_stage();
    return counts_;
  }

 private:
  FacetLabelCounts label_window(PointRank first_rank) const {
    context_.stop.check();
    const Reservation memory = context_.budget.reserve(kWindowMemory, "labelling facets");
    const NodeLabels labels = labels_.labels(first_rank);
    ExportWriter out(context_.scratch, first_rank, kLabelledPrefix);
    std::optional<RecordWriter<FacetRecord>> fills;
    FacetLabelCounts counts;
    std::vector<FacetRecord> facets;
    const auto visit = [&](std::span<const CandidateFacet> candidates) {
      facets.clear();
      for (const CandidateFacet& candidate : candidates) {
        const bool behind = labels.label(candidate.behind) == NodeLabel::kInside;
        const bool before = labels.label(candidate.before) == NodeLabel::kInside;
        if (candidate.is_pole_pair()) {
          counts.conflicts += behind == before ? 1 : 0;
        } else if (behind != before) {
          facets.push_back(facet_of(candidate, behind ? Facing::kOutward : Facing::kInward));
        }
      }
      counts.facets += facets.size();
      if (options_.sets_fills_apart) set_fills_apart(facets, first_rank, fills);
      export_solid_facets(facets, options_.exports, out);
    };
    windows_.visit<CandidateFacet>(ExportKind::kCandidates, first_rank, visit);
    out.finish();
    if (fills) fills->finish();
    return counts;
  }

  /// Into a file that is made for the first of them.
  void set_fills_apart(std::vector<FacetRecord>& facets, PointRank first_rank,
                       std::optional<RecordWriter<FacetRecord>>& out) const {
    const auto first = std::stable_partition(
        facets.begin(), facets.end(),
        [](const FacetRecord& facet) { return facet.source != TriangleSource::kFill; });
    if (first == facets.end()) return;
    if (!out) {
      out.emplace(create_records<FacetRecord>(context_.scratch,
                                              export_name(first_rank, kFillsPrefix), kFillsBlock));
    }
    out->append(std::span<const FacetRecord>(first, facets.end()));
    facets.erase(first, facets.end());
  }

  void take(const FacetLabelCounts& counts) {
    const std::lock_guard lock(mutex_);
    counts_.facets += counts.facets;
    counts_.conflicts += counts.conflicts;
    context_.progress.advance(1);
  }

  const ExportReader& windows_;
  const WindowLabels& labels_;
  const FacetLabelOptions& options_;
  const StageContext& context_;
  std::mutex mutex_;
  FacetLabelCounts counts_;
};

}  // namespace

FacetLabelCounts label_facets(const ExportReader& windows, const WindowLabels& labels,
                              const FacetLabelOptions& options, const StageContext& context) {
  return FacetLabels(windows, labels, options, context).run();
}

}  // namespace stream_recon
