// Joins the evidence of consecutive parts to that of one.
//
// Guarantees: nodes whose ranks all lie between those of the parts are private now and contracted
// (signed_forest.h); what every node of the parts hangs on is kept on disk, part by part.
// Thread rule: one thread. Memory: join_memory(), reserved. Cost: a merge of all nodes and one of
// all edges, about 300 ns a record.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "engine/labels/attachment.h"
#include "engine/labels/evidence_part.h"
#include "engine/stage_context.h"

namespace stream_recon {

struct JoinedParts {
  EvidencePart part;             ///< its files are named as asked
  std::uint64_t contracted = 0;  ///< nodes that are in no part any more
};

/// Where the attachments of the nodes of all parts lie, one part after the other: positions in the
/// joined part's table. Records: Attachment.
inline std::string attachments_file(const EvidencePart& joined) {
  return joined.name + "_attachments";
}

struct JoinSize {
  std::uint64_t parts = 0;
  std::uint64_t nodes = 0;  ///< of all parts

  void add(const EvidencePart& part) {
    ++parts;
    nodes += part.nodes;
  }
};

/// Bytes.
std::uint64_t join_memory(const JoinSize& size);

/// \param parts consecutive; they are left as they are
/// \param name of the joined part \throw IoError, BudgetError, Interrupted
JoinedParts join_parts(const EvidenceSource& source, std::span<const EvidencePart> parts,
                       const std::string& name, const StageContext& context);

}  // namespace stream_recon
