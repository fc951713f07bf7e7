#include "engine/labels/label_descent.h"

#include <algorithm>
#include <cstdint>
#include <span>
#include <string>
#include <utility>

#include "engine/labels/attachment.h"
#include "engine/labels/part_join.h"
#include "io/error.h"

namespace stream_recon {
namespace {

constexpr std::size_t kBatch = 1 << 13;

class LevelDescent {
 public:
  LevelDescent(LabelFile& out, const StageContext& context)
      : out_(out),
        context_(context),
        memory_(context.budget.reserve(
            record_cursor_memory(kEvidenceBlock) + kBatch * sizeof(Attachment),
            "labels of tetrahedra")),
        batch_(kBatch) {}

  /// \param above of the joined part
  void run(const EvidencePart& joined, std::span<const EvidencePart> parts,
           const NodeLabels& above) {
    ScratchReader<Attachment> reader(context_.scratch, attachments_file(joined));
    for (const EvidencePart& part : parts) {
      out_.begin_table(part.nodes);
      for (std::uint64_t rest = part.nodes; rest != 0;) {
        context_.stop.check();
        const auto batch = std::span(batch_).first(std::min<std::uint64_t>(rest, kBatch));
        if (reader.read(batch) != batch.size()) {
          throw IoError("the scratch file " + attachments_file(joined) +
                        " is too short; check the disk and run again");
        }
        for (const Attachment& at : batch) out_.append(above.label(at));
        context_.progress.advance(batch.size());
        rest -= batch.size();
      }
    }
  }

 private:
  LabelFile& out_;
  const StageContext& context_;
  Reservation memory_;
  std::vector<Attachment> batch_;
};

/// The table of the whole has the infinite node, if any, which is outside.
std::unique_ptr<const LabelFile> whole(const EvidencePart& part, const StageContext& context) {
  auto labels = std::make_unique<LabelFile>("labels_whole", 1, context);
  labels->begin_table(part.nodes);
  for (std::uint64_t node = 0; node < part.nodes; ++node) labels->append(NodeLabel::kOutside);
  labels->finish();
  return labels;
}

std::uint64_t count_nodes(std::span<const ForestLevel> levels) {
  std::uint64_t nodes = 0;
  for (const ForestLevel& level : levels) {
    for (const EvidencePart& part : level.parts) nodes += part.nodes;
  }
  return nodes;
}

}  // namespace

std::unique_ptr<const LabelFile> descend(std::vector<ForestLevel> levels,
                                         const StageContext& context) {
  auto above = whole(levels.back().parts.front(), context);
  context.progress.begin_stage("labels", count_nodes(std::span(levels).first(levels.size() - 1)),
                               "nodes");
  for (; levels.size() > 1; levels.pop_back()) {
    const ForestLevel& joined = levels.back();
    const std::span<const EvidencePart> parts = levels[levels.size() - 2].parts;
    auto labels = std::make_unique<LabelFile>("labels_" + std::to_string(levels.size() - 2),
                                              parts.size(), context);
    {
      LevelDescent descent(*labels, context);
      std::size_t begin = 0;
      for (std::size_t i = 0; i < joined.parts.size(); ++i) {
        descent.run(joined.parts[i], parts.subspan(begin, joined.ends[i] - begin),
                    above->labels(i));
        context.scratch.remove(attachments_file(joined.parts[i]));
        begin = joined.ends[i];
      }
    }
    labels->finish();
    above = std::move(labels);
  }
  context.progress.end_stage();
  return above;
}

}  // namespace stream_recon
