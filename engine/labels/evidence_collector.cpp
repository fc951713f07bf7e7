#include "engine/labels/evidence_collector.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "engine/labels/candidate_facet.h"
#include "engine/labels/evidence_export.h"
#include "engine/labels/signed_forest.h"
#include "engine/labels/window_evidence.h"
#include "engine/node_set.h"
#include "engine/poles/pole_export.h"
#include "engine/poles/ranked_cell.h"
#include "engine/poles/star_balls.h"
#include "engine/surface/ranked_facet.h"
#include "engine/windows/export_writer.h"
#include "engine/windows/final_simplices.h"
#include "spatial/gamma_facet.h"

namespace stream_recon {
namespace {

/// Whether other windows may have evidence about a finite cell.
bool is_shared(const FinalWindow& window, const std::array<VertexId, 4>& v) {
  return !window.owns_vertex(std::max(std::max(v[0], v[1]), std::max(v[2], v[3])));
}

class Collection {
 public:
  Collection(const FinalWindow& window, const StarBalls& balls, std::vector<float> spacing,
             ExportWriter& out)
      : window_(window),
        cells_(window.delaunay().view()),
        nodes_(balls.cells()),
        scale_(balls.scale()),
        out_(out),
        spacing_(std::move(spacing)),
        evidence_(window, spacing_, balls) {}

  /// The balls are no longer needed.
  void run(const StopRequest& stop) {
    stop.check();
    contract();
    stop.check();
    export_border();
    stop.check();
    const auto prepare = [this](CellId cell) {
      for (int side = 0; side < 4; ++side) {
        const CellId beyond = cells_.neighbor(cell, side);
        if (beyond > cell) __builtin_prefetch(&attachment(beyond));
      }
      cells_.prefetch_points(cell);
    };
    nodes_.for_each(prepare, [this](CellId cell) { find_open_facets(cell); });
    export_open_facets();
    for (VertexId v = 0; v < window_.owned_count(); ++v) export_pole_pair(v);
  }

  void export_balls_of_poles(double least_ball) {
    // What reaches for a far point lies outside, whatever the evidence says.
    const auto attachment_of = [this](CellId cell) {
      const auto v = cells_.vertices(cell);
      const bool is_far =
          std::any_of(v.begin(), v.end(), [this](VertexId i) { return spacing_[i] == kNoSample; });
      return is_far ? Attachment{} : attachment(cell);
    };
    // Far points have no spacing, which is less than any.
    const auto is_too_small = [&](CellId cell, double radius) {
      double spacing = 0;
      for (const VertexId v : cells_.vertices(cell))
        spacing = std::max(spacing, double{spacing_[v]});
      return radius * scale_ < least_ball * spacing;
    };
    export_poles(window_, evidence_.poles(), {attachment_of, is_too_small}, out_);
  }

 private:
  std::uint32_t infinite_node() const { return nodes_.count(); }
  std::uint32_t node(CellId cell) const {
    return nodes_.contains(cell) ? nodes_.position(cell) : infinite_node();
  }
  const Attachment& attachment(CellId cell) const { return contraction_.attachments[node(cell)]; }

  /// All cells that another window may know, and the infinite node.
  NodeSet find_border() const {
    NodeSet border(nodes_.count() + 1);
    std::uint32_t number = 0;
    nodes_.for_each([&](CellId cell) {
      if (is_shared(window_, cells_.vertices(cell))) border.insert(number);
      ++number;
    });
    border.insert(infinite_node());
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
    std::uint32_t number = 0;
    nodes_.for_each([&](CellId cell) {
      if (border_.contains(number++)) keys.push_back(RankedCell(window_, cells_, cell).key());
    });
    keys.push_back(kInfiniteNode);
    export_evidence({window_.first_rank(), border_, keys}, contraction_, out_);
    contraction_.edges = {};
  }

  /// Those that the window emits and whose two cells are not known to lie on the same side.
  void find_open_facets(CellId cell) {
    const Attachment inner = attachment(cell);
    for (int side = 0; side < 4; ++side) {
      const CellId beyond = cells_.neighbor(cell, side);
      if (beyond < cell && nodes_.contains(beyond)) continue;
      if (!emits(window_, cells_.facet(cell, side))) continue;
      const Attachment outer = attachment(beyond);
      if (inner == outer) continue;
      cells_.prefetch(beyond);
      open_[open_count_++] = {cell, side, inner, outer};
      if (open_count_ == open_.size()) export_open_facets();
    }
  }

  struct OpenFacet {
    CellId cell;
    int side;
    Attachment inner;  ///< of the cell
    Attachment outer;
  };

  // The cells beyond lie anywhere in memory, so do their points: first all are asked for.
  void export_open_facets() {
    const std::span<const OpenFacet> facets = std::span(open_).first(open_count_);
    for (const OpenFacet& open : facets) {
      const CellId beyond = cells_.neighbor(open.cell, open.side);
      if (!nodes_.contains(beyond)) continue;
      cells_.prefetch_point(cells_.vertex(beyond, cells_.mirror_index(open.cell, open.side)));
    }
    for (const OpenFacet& open : facets) export_facet(open);
    open_count_ = 0;
  }

  void export_facet(const OpenFacet& open) {
    const RankedFacet facet(window_, cells_.facet(open.cell, open.side));
    const FacetBalls balls = balls_beside(cells_, facet, open.cell, open.side);
    double spacing = 0;
    for (const VertexId v : facet.vertices) spacing = std::max(spacing, double{spacing_[v]});
    CandidateFacet candidate;
    for (int i = 0; i < 3; ++i) candidate.ranks[i] = static_cast<std::uint32_t>(facet.ranks[i]);
    candidate.delta = static_cast<float>(gamma_angle(balls));
    candidate.behind = facet.reversed ? open.outer : open.inner;
    candidate.before = facet.reversed ? open.inner : open.outer;
    candidate.closure = closure_code(static_cast<float>(balls.radius * scale_ / spacing));
    candidate.source = gamma_.takes(balls) ? TriangleSource::kGamma : TriangleSource::kFill;
    out_.add(ExportKind::kCandidates, window_.first_rank(), candidate);
  }

  /// Unless they are known to lie on opposite sides.
  void export_pole_pair(VertexId v) {
    const PolePair pair = evidence_.poles().pair(v);
    if (!pair.is_complete()) return;
    const bool is_hull = pair.first == PolePair::kInfinity;
    const Attachment first =
        is_hull ? contraction_.attachments[infinite_node()] : attachment(pair.first);
    const Attachment second = attachment(pair.second);
    if (first.node == second.node && first.is_opposite != second.is_opposite) return;
    const auto rank = static_cast<std::uint32_t>(window_.rank(v));
    CandidateFacet candidate{.ranks = {rank, rank, rank}, .behind = first, .before = second};
    out_.add(ExportKind::kCandidates, window_.first_rank(), candidate);
  }

  const FinalWindow& window_;
  const CellView cells_;
  const NodeSet& nodes_;
  const double scale_;
  ExportWriter& out_;
  const GammaCriterion gamma_{90};
  std::vector<float> spacing_;
  WindowEvidence evidence_;
  const NodeSet border_ = find_border();
  Contraction contraction_;
  std::array<OpenFacet, 32> open_;  ///< not exported yet
  std::size_t open_count_ = 0;
};

}  // namespace

void EvidenceCollector::consume(const FinalWindow& window, ExportWriter& out) {
  const std::size_t vertices = window.delaunay().vertex_count();
  std::vector<float> spacing(vertices);
  {
    SpacingReader reader(spacings_);
    for (VertexId v = 0; v < vertices; ++v) {
      const bool is_sample = window.input_index(v) < options_.samples;
      spacing[v] = is_sample ? reader.at(window.rank(v)) : kNoSample;
    }
  }
  StarBalls balls(window, spacings_.scale());
  Collection collection(window, balls, std::move(spacing), out);
  balls.drop_centres();
  collection.run(stop_);
  if (options_.hands_on_poles) collection.export_balls_of_poles(options_.least_ball);
}

// The forest comes when the centres are gone, what is exported when the entries are.
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
  const std::uint64_t entries = WindowEvidence::memory(with_owned, window.owned_count());
  const std::uint64_t poles = StarPoles::memory(window.owned_count());
  const std::uint64_t edges = border * sizeof(EvidenceEdge);
  const std::uint64_t forest = SignedForest::memory(with_owned + 1);
  const std::uint64_t evidence = StarBalls::centre_memory(with_owned) + entries;
  const std::uint64_t contracting = entries + forest + edges;
  const std::uint64_t exporting =
      poles + forest + edges + border * sizeof(NodeKey) + evidence_export_memory(border);
  const std::uint64_t balls =
      options_.hands_on_poles ? poles + forest + pole_export_memory(window.owned_count()) : 0;
  return SpacingReader::kMemory + window.delaunay().vertex_count() * sizeof(float) +
         NodeSet::memory(cells.slots()) + NodeSet::memory(with_owned + 1) +
         std::max({evidence, contracting, exporting, balls});
}

}  // namespace stream_recon
