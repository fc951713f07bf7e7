#include "engine/labels/signed_forest.h"

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <utility>

#include "engine/labels/evidence_sort.h"

namespace stream_recon {
namespace {

/// Which of two roots stays a root: as good as chance, so that trees stay flat.
bool goes_below(std::uint32_t x, std::uint32_t y) {
  constexpr std::uint32_t kScatter = 0x9e3779b9;
  return x * kScatter < y * kScatter;
}

}  // namespace

SignedForest::SignedForest(const NodeSet& border) : links_(border.size()) {
  assert(border.size() <= Attachment::kMostNodes);
  for (std::uint32_t node = 0; node < border.size(); ++node) {
    links_[node].node = node;
    links_[node].is_attached = border.contains(node);
  }
}

Attachment SignedForest::find_top(std::uint32_t node) {
  bool is_opposite = false;
  for (;;) {
    Attachment& link = links_[node];
    if (link.is_attached || link.node == node) return {node, link.is_attached, is_opposite};
    const Attachment next = links_[link.node];
    if (next.is_attached || next.node == link.node) {
      return {link.node, next.is_attached, is_opposite != link.is_opposite};
    }
    link.is_opposite = link.is_opposite != next.is_opposite;
    link.node = next.node;
    is_opposite = is_opposite != link.is_opposite;
    node = link.node;
  }
}

std::uint32_t SignedForest::find_component(std::uint32_t border) {
  while (links_[border].node != border) {
    links_[border].node = links_[links_[border].node].node;
    border = links_[border].node;
  }
  return border;
}

std::optional<EvidenceEdge> SignedForest::add(const EvidenceEdge& edge) {
  assert(edge.weight <= last_weight_);
  last_weight_ = edge.weight;
  Attachment top_a = find_top(edge.a);
  Attachment top_b = find_top(edge.b);
  const bool is_opposite = edge.is_opposite != (top_a.is_opposite != top_b.is_opposite);

  if (!top_a.is_attached || !top_b.is_attached) {
    if (top_a.node == top_b.node) return std::nullopt;
    const bool a_stays =
        top_a.is_attached || (!top_b.is_attached && goes_below(top_b.node, top_a.node));
    if (a_stays) std::swap(top_a, top_b);
    links_[top_a.node] = {top_b.node, false, is_opposite};
    return std::nullopt;
  }
  const std::uint32_t root_a = find_component(top_a.node);
  const std::uint32_t root_b = find_component(top_b.node);
  if (root_a == root_b) return std::nullopt;
  const bool a_goes = goes_below(root_a, root_b);
  links_[a_goes ? root_a : root_b].node = a_goes ? root_b : root_a;
  return EvidenceEdge{.a = top_a.node,
                      .b = top_b.node,
                      .is_opposite = is_opposite,
                      .weight = edge.weight,
                      .tie = edge.tie};
}

std::vector<Attachment> SignedForest::attachments() && {
  for (std::uint32_t node = 0; node < links_.size(); ++node) {
    const Attachment top = find_top(node);
    if (links_[node].is_attached) {
      links_[node].node = node;
    } else {
      links_[node].node = top.node;
      links_[node].is_opposite = top.is_opposite;
    }
  }
  // Only now, because private nodes that are marked would be taken for border nodes above.
  for (Attachment& link : links_) link.is_attached = links_[link.node].is_attached;
  return std::move(links_);
}

Contraction contract(const NodeSet& border, std::vector<EvidenceEdge> edges) {
  sort_evidence(edges);
  SignedForest forest(border);
  std::size_t kept = 0;
  for (const EvidenceEdge& edge : edges) {
    if (const auto left = forest.add(edge)) edges[kept++] = *left;
  }
  edges.resize(kept);
  Contraction result{.attachments = std::move(forest).attachments(), .edges = std::move(edges)};
  result.unattached = static_cast<std::uint64_t>(
      std::count_if(result.attachments.begin(), result.attachments.end(),
                    [](const Attachment& at) { return !at.is_attached; }));
  return result;
}

}  // namespace stream_recon
