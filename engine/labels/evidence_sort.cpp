#include "engine/labels/evidence_sort.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <utility>

namespace stream_recon {
namespace {

constexpr std::size_t kBuckets = 256;
constexpr std::size_t kFewEdges = 48;
/// The weight and the three parts of the tie.
constexpr int kFields = 4;

/// Rises in the order of the edges. The bits of floats that are not negative rise with them.
std::uint32_t key_of(const EvidenceEdge& edge, int field) {
  if (field > 0) return edge.tie[static_cast<std::size_t>(field - 1)];
  return ~std::bit_cast<std::uint32_t>(edge.weight + 0.0F);  // -0 becomes 0
}

struct Digit {
  int field = 0;
  std::uint32_t least = 0;
  int shift = 0;

  std::size_t of(const EvidenceEdge& edge) const { return (key_of(edge, field) - least) >> shift; }
};

using Bounds = std::array<std::uint32_t, kBuckets + 1>;

/// Moves every edge into the bucket of its digit. \return Where the buckets begin
Bounds distribute(std::span<EvidenceEdge> edges, const Digit& digit) {
  Bounds bounds{};
  for (const EvidenceEdge& edge : edges) ++bounds[digit.of(edge) + 1];
  for (std::size_t i = 0; i < kBuckets; ++i) bounds[i + 1] += bounds[i];
  Bounds next = bounds;
  for (std::size_t bucket = 0; bucket < kBuckets; ++bucket) {
    while (next[bucket] < bounds[bucket + 1]) {
      EvidenceEdge& edge = edges[next[bucket]];
      for (std::size_t home = digit.of(edge); home != bucket; home = digit.of(edge)) {
        std::swap(edge, edges[next[home]++]);
      }
      ++next[bucket];
    }
  }
  return bounds;
}

/// \pre The edges agree in all fields before `field`.
void sort_from(std::span<EvidenceEdge> edges, int field) {
  if (edges.size() <= kFewEdges) {
    std::sort(edges.begin(), edges.end(), comes_before);
    return;
  }
  for (; field < kFields; ++field) {
    const auto key = [field](const EvidenceEdge& edge) { return key_of(edge, field); };
    std::uint32_t least = key(edges[0]);
    std::uint32_t most = least;
    for (const EvidenceEdge& edge : edges) {
      least = std::min(least, key(edge));
      most = std::max(most, key(edge));
    }
    if (least == most) continue;
    const int shift = std::max(0, static_cast<int>(std::bit_width(most - least)) - 8);
    const Bounds bounds = distribute(edges, {field, least, shift});
    for (std::size_t i = 0; i < kBuckets; ++i) {
      sort_from(edges.subspan(bounds[i], bounds[i + 1] - bounds[i]), field);
    }
    return;
  }
}

}  // namespace

void sort_evidence(std::span<EvidenceEdge> edges) {
  assert(std::all_of(edges.begin(), edges.end(), [](const EvidenceEdge& edge) {
    return std::isfinite(edge.weight) && edge.weight >= 0;
  }));
  assert(std::in_range<std::uint32_t>(edges.size()));
  sort_from(edges, 0);
}

}  // namespace stream_recon
