#include "engine/labels/evidence_collector.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include "engine/labels/candidate_facet.h"
#include "engine/labels/evidence_export.h"
#include "engine/labels/signed_forest.h"
#include "engine/labels/window_evidence.h"
#include "engine/windows/export_writer.h"
#include "engine/windows/final_simplices.h"
#include "spatial/gamma_facet.h"

namespace stream_recon {
namespace {

/// Whether other windows may have evidence about a finite cell.
bool is_shared(const FinalWindow& window, const std::array<VertexId, 4>& v) {
  return !window.owns_vertex(std::max(std::max(v[0], v[1]), std::max(v[2], v[3])));
}

bool has_owned(const FinalWindow& window, const std::array<VertexId, 4>& v) {
  return window.owns_vertex(std::min(std::min(v[0], v[1]), std::min(v[2], v[3])));
}

NodeKey key_of(const FinalWindow& window, const std::array<VertexId, 4>& v) {
  NodeKey key;
  for (int i = 0; i < 4; ++i) key.ranks[i] = static_cast<std::uint32_t>(window.rank(v[i]));
  std::sort(key.ranks.begin(), key.ranks.end());
  return key;
}

class Collection {
 public:
  Collection(const FinalWindow& window, std::vector<float> spacing, ExportWriter& out)
      : window_(window),
        cells_(window.delaunay().view()),
        out_(out),
        spacing_(std::move(spacing)),
        evidence_(window, spacing_) {}

  void run(const StopRequest& stop) {
    stop.check();
    contract();
    stop.check();
    export_border();
    stop.check();
    for_each_final_facet(window_, {0, cells_.slots()},
                         [this](CellId cell, int side) { export_facet(cell, side); });
    for (VertexId v = 0; v < window_.owned_count(); ++v) export_poles(v);
  }

 private:
  /// All cells that another window may know, and the infinite node.
  NodeSet find_border() const {
    NodeSet border(cells_.slots() + 1);
    for (CellId cell = 0; cell < cells_.slots(); ++cell) {
      if (!cells_.is_live(cell) || cells_.is_infinite(cell)) continue;
      const auto v = cells_.vertices(cell);
      if (has_owned(window_, v) && is_shared(window_, v)) border.insert(cell);
    }
    border.insert(evidence_.infinite_node());
    border.number();
    return border;
  }

  void contract() {
    SignedForest forest(border_);
    contraction_.edges = evidence_.contract(forest, border_.count());
    contraction_.attachments = std::move(forest).attachments();
  }

  void export_border() {
    std::vector<NodeKey> keys;
    keys.reserve(border_.count());
    for (CellId cell = 0; cell < cells_.slots(); ++cell) {
      if (border_.contains(cell)) keys.push_back(key_of(window_, cells_.vertices(cell)));
    }
    keys.push_back(kInfiniteNode);
    export_evidence({window_.first_rank(), border_, keys}, contraction_, out_);
    contraction_.edges = {};
  }

  void export_facet(CellId cell, int side) {
    const Attachment inner = contraction_.attachments[cell];
    const Attachment outer = contraction_.attachments[evidence_.node(cells_.neighbor(cell, side))];
    if (inner == outer) return;
    const RankedFacet facet(window_, cells_.facet(cell, side));
    const FacetBalls balls = evidence_.balls(facet, cell, side);
    CandidateFacet candidate;
    for (int i = 0; i < 3; ++i) candidate.ranks[i] = static_cast<std::uint32_t>(facet.ranks[i]);
    candidate.delta = static_cast<float>(gamma_angle(balls));
    candidate.behind = facet.reversed ? outer : inner;
    candidate.before = facet.reversed ? inner : outer;
    candidate.closure = closure_code(static_cast<float>(balls.radius / evidence_.spacing(facet)));
    candidate.source = gamma_.takes(balls) ? TriangleSource::kGamma : TriangleSource::kFill;
    out_.add(ExportKind::kCandidates, window_.first_rank(), candidate);
  }

  /// Unless they are known to lie on opposite sides.
  void export_poles(VertexId v) {
    const PolePair pair = evidence_.poles().pair(v);
    if (!pair.is_complete()) return;
    const bool is_hull = pair.first == PolePair::kInfinity;
    const Attachment first =
        contraction_.attachments[is_hull ? evidence_.infinite_node() : pair.first];
    const Attachment second = contraction_.attachments[pair.second];
    if (first.node == second.node && first.is_opposite != second.is_opposite) return;
    const auto rank = static_cast<std::uint32_t>(window_.rank(v));
    CandidateFacet candidate{.ranks = {rank, rank, rank}, .behind = first, .before = second};
    out_.add(ExportKind::kCandidates, window_.first_rank(), candidate);
  }

  const FinalWindow& window_;
  const CellView cells_;
  ExportWriter& out_;
  const GammaCriterion gamma_{90};
  std::vector<float> spacing_;
  WindowEvidence evidence_;
  const NodeSet border_ = find_border();
  Contraction contraction_;
};

}  // namespace

void EvidenceCollector::consume(const FinalWindow& window, ExportWriter& out) {
  const std::size_t vertices = window.delaunay().vertex_count();
  std::vector<float> spacing(vertices);
  {
    SpacingReader reader(spacings_);
    for (VertexId v = 0; v < vertices; ++v) {
      spacing[v] = static_cast<float>(reader.at(window.rank(v)));
    }
  }
  Collection(window, std::move(spacing), out).run(stop_);
}

std::uint64_t EvidenceCollector::memory(const FinalWindow& window) const {
  const CellView cells = window.delaunay().view();
  std::uint64_t border = 1;
  std::uint64_t with_owned = 0;
  for (CellId cell = 0; cell < cells.slots(); ++cell) {
    if (!cells.is_live(cell)) continue;
    const auto v = cells.vertices(cell);
    if (!has_owned(window, v)) continue;
    ++with_owned;
    border += is_shared(window, v) ? 1 : 0;
  }
  const std::uint64_t beside_entries = border * (sizeof(NodeKey)) + evidence_export_memory(border);
  return SpacingReader::kMemory + window.delaunay().vertex_count() * sizeof(float) +
         NodeSet::memory(cells.slots()) + SignedForest::memory(cells.slots()) +
         border * sizeof(EvidenceEdge) +
         std::max(WindowEvidence::memory(with_owned, window.owned_count()), beside_entries);
}

}  // namespace stream_recon
