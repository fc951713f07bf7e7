#include "engine/labels/evidence_export.h"

#include <algorithm>
#include <boost/sort/spreadsort/integer_sort.hpp>
#include <cassert>
#include <vector>

namespace stream_recon {
namespace {

/// Numbers of keys in the order of the keys. The first ranks, in the upper halves while it is made,
/// tell most apart without a look at the keys, which lie anywhere in memory.
std::vector<std::uint64_t> sorted_numbers(std::span<const NodeKey> keys) {
  const auto rank_of = [](std::uint64_t entry) { return entry >> 32; };
  const auto number_of = [](std::uint64_t entry) { return entry & 0xffffffff; };
  std::vector<std::uint64_t> order(keys.size());
  for (std::uint64_t i = 0; i < order.size(); ++i) {
    order[i] = std::uint64_t{keys[i].ranks[0]} << 32 | i;
  }
  boost::sort::spreadsort::integer_sort(order.begin(), order.end());
  for (auto begin = order.begin(); begin != order.end();) {
    const auto end = std::find_if(
        begin, order.end(), [&](std::uint64_t entry) { return rank_of(entry) != rank_of(*begin); });
    std::sort(begin, end, [&](std::uint64_t x, std::uint64_t y) {
      return keys[number_of(x)] < keys[number_of(y)];
    });
    begin = end;
  }
  for (std::uint64_t& entry : order) entry = number_of(entry);
  return order;
}

}  // namespace

void export_evidence(const WindowBorder& border, Contraction& contraction, ExportWriter& out) {
  assert(border.keys.size() == border.nodes.count());
  const std::vector<std::uint64_t> order = sorted_numbers(border.keys);
  std::vector<std::uint32_t> places(order.size());
  for (std::uint32_t place = 0; place < order.size(); ++place) {
    const NodeKey& key = border.keys[order[place]];
    assert(place == 0 || border.keys[order[place - 1]] < key);
    places[order[place]] = place;
    out.add(ExportKind::kEvidenceNodes, border.first_rank, key);
  }
  const auto place_of = [&](std::uint32_t node) { return places[border.nodes.position(node)]; };
  for (EvidenceEdge& edge : contraction.edges) {
    edge.a = place_of(edge.a);
    edge.b = place_of(edge.b);
    out.add(ExportKind::kEvidenceEdges, border.first_rank, edge);
  }
  for (Attachment& attachment : contraction.attachments) {
    if (attachment.is_attached) attachment.node = place_of(attachment.node);
  }
}

}  // namespace stream_recon
