#include "tools/check/vertex_star.h"

#include <algorithm>
#include <numeric>

namespace stream_recon {

void VertexStar::take(std::span<const StarRecord> records) {
  collect_edges(records);
  is_fan_ = is_one_fan(records);
  duplicates_ = 0;
  for (std::size_t i = 1; i < records.size(); ++i) {
    const StarRecord& a = records[i - 1];
    const StarRecord& b = records[i];
    if (b.vertex < b.low && a.low == b.low && a.high == b.high) ++duplicates_;
  }
}

void VertexStar::collect_edges(std::span<const StarRecord> records) {
  uses_.clear();
  for (const StarRecord& record : records) {
    const bool is_reversed = record.is_reversed != 0;
    uses_.push_back({record.low, !is_reversed});
    uses_.push_back({record.high, is_reversed});
  }
  std::sort(uses_.begin(), uses_.end(),
            [](const Use& a, const Use& b) { return a.other < b.other; });
  edges_.clear();
  for (const Use& use : uses_) {
    if (edges_.empty() || edges_.back().other != use.other) edges_.push_back({use.other});
    ++(use.is_outward ? edges_.back().outward : edges_.back().inward);
  }
}

// A connected link none of whose vertices has more than two edges is a path or a circle.
bool VertexStar::is_one_fan(std::span<const StarRecord> records) {
  if (std::any_of(edges_.begin(), edges_.end(),
                  [](const StarEdge& edge) { return edge.is_nonmanifold(); })) {
    return false;
  }
  parents_.resize(edges_.size());
  std::iota(parents_.begin(), parents_.end(), 0);
  std::size_t parts = edges_.size();
  for (const StarRecord& record : records) {
    const std::uint32_t a = root_of(position_of(record.low));
    const std::uint32_t b = root_of(position_of(record.high));
    if (a != b) --parts;
    parents_[std::max(a, b)] = std::min(a, b);
  }
  return parts == 1;
}

std::uint32_t VertexStar::position_of(std::uint64_t other) const {
  const auto found =
      std::lower_bound(edges_.begin(), edges_.end(), other,
                       [](const StarEdge& edge, std::uint64_t end) { return edge.other < end; });
  return static_cast<std::uint32_t>(found - edges_.begin());
}

std::uint32_t VertexStar::root_of(std::uint32_t position) {
  while (parents_[position] != position) {
    parents_[position] = parents_[parents_[position]];
    position = parents_[position];
  }
  return position;
}

}  // namespace stream_recon
