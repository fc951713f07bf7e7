#include "engine/labels/join_plan.h"

#include <algorithm>
#include <limits>

#include "engine/labels/attachment.h"
#include "engine/labels/part_join.h"

namespace stream_recon {

std::vector<std::size_t> plan_joins(std::span<const EvidencePart> parts,
                                    std::uint64_t memory_bytes) {
  std::vector<std::size_t> ends;
  for (std::size_t end = 0; end < parts.size();) {
    JoinSize size;
    do {
      size.add(parts[end++]);
      if (end == parts.size()) break;
      JoinSize larger = size;
      larger.add(parts[end]);
      if (join_memory(larger) > memory_bytes || larger.nodes > Attachment::kMostNodes) break;
    } while (true);
    ends.push_back(end);
  }
  return ends;
}

std::uint64_t least_join_memory(std::span<const EvidencePart> parts) {
  std::uint64_t least = std::numeric_limits<std::uint64_t>::max();
  for (std::size_t i = 1; i < parts.size(); ++i) {
    JoinSize size;
    size.add(parts[i - 1]);
    size.add(parts[i]);
    least = std::min(least, join_memory(size));
  }
  return least;
}

}  // namespace stream_recon
