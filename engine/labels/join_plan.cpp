#include "engine/labels/join_plan.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "engine/labels/attachment.h"
#include "engine/labels/part_join.h"

namespace stream_recon {

namespace {

bool fits(const JoinSize& size, std::uint64_t memory_bytes) {
  return join_memory(size) <= memory_bytes && size.nodes <= Attachment::kMostNodes;
}

/// Into `shares` groups of about as many nodes, or more if `memory_bytes` do not hold those.
std::vector<std::size_t> share_out(std::span<const EvidencePart> parts, std::uint64_t shares,
                                   std::uint64_t memory_bytes) {
  std::uint64_t nodes = 0;
  for (const EvidencePart& part : parts) nodes += part.nodes;
  std::vector<std::size_t> ends;
  JoinSize group;
  std::uint64_t before = 0;
  std::uint64_t last_share = 0;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    // Where its middle lies.
    const std::uint64_t share = (2 * before + parts[i].nodes) * shares / (2 * nodes + 1);
    JoinSize larger = group;
    larger.add(parts[i]);
    if (i != 0 && (share != last_share || !fits(larger, memory_bytes))) {
      ends.push_back(i);
      group = {};
    }
    group.add(parts[i]);
    before += parts[i].nodes;
    last_share = share;
  }
  ends.push_back(parts.size());
  return ends;
}

}  // namespace

JoinPlan plan_joins(std::span<const EvidencePart> parts, const JoinResources& resources) {
  const std::uint64_t most = parts.size() / 2;
  for (std::uint64_t n = std::min(resources.threads, most); n > 1; --n) {
    auto ends = share_out(parts, n, resources.memory_bytes / n);
    if (ends.size() <= most) return {std::move(ends), n};
  }
  return {share_out(parts, 1, resources.memory_bytes), 1};
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
