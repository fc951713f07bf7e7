#include "engine/labels/evidence_export.h"

#include <algorithm>
#include <cassert>
#include <numeric>
#include <vector>

namespace stream_recon {

void export_evidence(const WindowBorder& border, Contraction& contraction, ExportWriter& out) {
  assert(border.keys.size() == border.nodes.count());
  std::vector<std::uint32_t> order(border.keys.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(),
            [&](std::uint32_t x, std::uint32_t y) { return border.keys[x] < border.keys[y]; });
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
