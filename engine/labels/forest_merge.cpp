#include "engine/labels/forest_merge.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <span>
#include <string>
#include <utility>

#include "engine/chunks/chunk_loop.h"
#include "engine/labels/join_plan.h"
#include "engine/labels/label_descent.h"
#include "engine/labels/part_join.h"
#include "engine/parallel.h"

namespace stream_recon {
namespace {

/// What a window is to the merge: a part, in all levels together about two, and its first rank.
constexpr std::uint64_t kBytesAWindow = 2 * sizeof(EvidencePart) + 3 * sizeof(PointRank);

class ForestMerge {
 public:
  ForestMerge(const ExportReader& exports, const StageContext& context)
      : source_{context.scratch, exports},
        context_(context),
        first_ranks_(exports.chunks(ExportKind::kEvidenceNodes)),
        memory_(context.budget.reserve(first_ranks_.size() * kBytesAWindow,
                                       "the list of the windows' evidence")) {}

  MergedForest run() {
    if (first_ranks_.empty()) return {};
    levels_.push_back(windows());
    do {
      join_level();
    } while (levels_.back().parts.size() > 1);
    remove_files(levels_.back().parts);
    counts_.nodes += levels_.back().parts.front().nodes;
    counts_.levels = levels_.size() - 1;
    auto labels = descend(std::move(levels_), context_);
    counts_.unattached = labels->unattached();
    memory_.resize(first_ranks_.size() * sizeof(PointRank));
    return {WindowLabels(std::move(first_ranks_), std::move(labels), std::move(memory_)), counts_};
  }

 private:
  /// Ranks between two windows with evidence are in windows without any, so that nodes there have
  /// no edges but in those two.
  ForestLevel windows() {
    ForestLevel level;
    for (std::size_t i = 0; i < first_ranks_.size(); ++i) {
      const bool is_last = i + 1 == first_ranks_.size();
      EvidencePart part{
          .first_rank = i == 0 ? 0 : first_ranks_[i],
          .end_rank = is_last ? std::numeric_limits<PointRank>::max() : first_ranks_[i + 1],
          .nodes = source_.exports.count(ExportKind::kEvidenceNodes, first_ranks_[i]),
          .edges = source_.exports.count(ExportKind::kEvidenceEdges, first_ranks_[i]),
          .chunk = first_ranks_[i],
          .name = {}};
      counts_.edges += part.edges;
      level.parts.push_back(std::move(part));
    }
    return level;
  }

  void join_level();
  void remove_files(std::span<const EvidencePart> parts) const {
    for (const EvidencePart& part : parts) {
      if (part.is_window()) continue;
      context_.scratch.remove(part.nodes_file());
      context_.scratch.remove(part.edges_file());
    }
  }

  EvidenceSource source_;
  const StageContext& context_;
  std::vector<PointRank> first_ranks_;
  Reservation memory_;
  std::vector<ForestLevel> levels_;
  ForestCounts counts_;
};

void ForestMerge::join_level() {
  const std::span<const EvidencePart> parts = levels_.back().parts;
  JoinPlan plan = plan_joins(parts, {context_.budget.available(), threads_in_use()});
  if (parts.size() > 1 && plan.ends.size() == parts.size()) {
    // Does not fit, and says by how much.
    (void)context_.budget.reserve(least_join_memory(parts),
                                  "joining the evidence of two neighbouring windows");
  }
  const std::string number = std::to_string(levels_.size());
  std::uint64_t records = 0;
  for (const EvidencePart& part : parts) records += part.nodes + part.edges;
  context_.progress.begin_stage("evidence, level " + number, records, "records");
  ForestLevel joined;
  const auto join = [&](std::uint64_t i) {
    const std::size_t begin = i == 0 ? 0 : plan.ends[i - 1];
    const auto group = parts.subspan(begin, plan.ends[i] - begin);
    const std::string name = "evidence_" + number + "_" + std::to_string(group[0].first_rank);
    JoinedParts result = join_parts(source_, group, name, context_);
    remove_files(group);
    return result;
  };
  const auto take = [&](std::uint64_t, JoinedParts result) {
    counts_.nodes += result.contracted;
    joined.parts.push_back(std::move(result.part));
  };
  for_each_chunk({.chunks = plan.ends.size(), .at_once = plan.at_once, .takes_in_order = true},
                 join, take);
  joined.ends = std::move(plan.ends);
  levels_.push_back(std::move(joined));
  context_.progress.end_stage();
}

}  // namespace

WindowLabels::WindowLabels(std::vector<PointRank> first_ranks,
                           std::unique_ptr<const LabelFile> labels, Reservation memory)
    : first_ranks_(std::move(first_ranks)),
      labels_(std::move(labels)),
      memory_(std::move(memory)) {}

NodeLabels WindowLabels::labels(PointRank first_rank) const {
  const auto at = std::lower_bound(first_ranks_.begin(), first_ranks_.end(), first_rank);
  if (at == first_ranks_.end() || *at != first_rank) return NodeLabels(0, Reservation());
  return labels_->labels(static_cast<std::uint64_t>(at - first_ranks_.begin()));
}

MergedForest merge_forest(const ExportReader& exports, const StageContext& context) {
  return ForestMerge(exports, context).run();
}

}  // namespace stream_recon
