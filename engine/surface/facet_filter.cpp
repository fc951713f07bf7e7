#include "engine/surface/facet_filter.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "engine/surface/ranked_facet.h"
#include "engine/windows/final_simplices.h"
#include "spatial/alpha_facet.h"
#include "spatial/cell_balls.h"
#include "spatial/facet_balls.h"
#include "spatial/gamma_facet.h"

namespace stream_recon {
namespace {

constexpr CellId kBlock = 1 << 12;
constexpr std::size_t kMostWaiting = 256;
constexpr std::size_t kMostTaken = (std::size_t{64} << 10) / sizeof(FacetRecord);

struct Facet {
  CellId cell;
  int side;
};

struct WaitingFacet {
  Facet facet;
  BallEstimate near;  ///< of its cell
};

/// One pass over the cells of a window, block by block. A facet is looked at from the lower in
/// number of its two cells; where the other lies beyond the block, it waits to be one of many.
template <class Criterion>
class FacetPass {
 public:
  struct Output {
    TriangleSource source;
    const ChunkLayout& layout;
    ExportWriter& out;
  };

  FacetPass(const FinalWindow& window, const Criterion& criterion, const Output& output)
      : window_(window),
        cells_(window.delaunay().view()),
        criterion_(criterion),
        output_(output),
        estimator_(cells_),
        place_(kBlock),
        balls_(kBlock),
        candidates_(4 * kBlock + 1) {
    block_.reserve(kBlock);
    waiting_.reserve(kMostWaiting);
    beyond_.reserve(kMostWaiting);
    taken_.reserve(kMostTaken);
  }

  void run(const StopRequest& stop) {
    for (begin_ = 0; begin_ < cells_.slots(); begin_ = end_) {
      stop.check();
      end_ = begin_ + std::min(kBlock, cells_.slots() - begin_);
      visit_block();
    }
    decide_waiting();
    hand_over();
  }

 private:
  void visit_block() {
    block_.clear();
    for (CellId cell = begin_; cell < end_; ++cell) {
      if (!cells_.is_live(cell) || !has_owned(window_, cells_.vertices(cell))) continue;
      if (cells_.is_infinite(cell)) {
        visit_hull(cell);
      } else {
        place_[cell - begin_] = static_cast<std::uint32_t>(block_.size());
        block_.push_back(cell);
      }
    }
    estimator_.estimate(block_, balls_);
    find_candidates();
    for (const Facet& facet : std::span(candidates_).first(candidate_count_)) visit(facet);
  }

  /// The facets that the near ball alone does not rule out. Which ones is hard to predict: no
  /// branches.
  void find_candidates() {
    std::size_t count = 0;
    for (std::size_t i = 0; i < block_.size(); ++i) {
      for (int side = 0; side < 4; ++side) {
        const bool is_first = cells_.neighbor(block_[i], side) > block_[i];
        const bool is_open =
            criterion_.judge(balls_[i].from(side), BallEstimate{}) != Verdict::kOut;
        candidates_[count] = {block_[i], side};
        count += static_cast<std::size_t>(is_first) & static_cast<std::size_t>(is_open);
      }
    }
    candidate_count_ = count;
  }

  const CellBall& ball_of(CellId cell) const { return balls_[place_[cell - begin_]]; }

  /// From an infinite cell: its finite facet waits if the cell behind it will not look at it.
  void visit_hull(CellId cell) {
    constexpr int kFinite = 3;
    if (cells_.neighbor(cell, kFinite) < cell) return;
    if (emits(window_, cells_.facet(cell, kFinite))) wait({cell, kFinite}, BallEstimate{});
  }

  void visit(const Facet& facet) {
    const auto [cell, side] = facet;
    if (!emits(window_, cells_.facet(cell, side))) return;
    const BallEstimate near = ball_of(cell).from(side);
    const CellId beyond = cells_.neighbor(cell, side);
    if (beyond >= end_) {
      wait(facet, near);
    } else if (cells_.is_infinite(beyond)) {
      decide(facet, near, BallEstimate{});
    } else {
      decide(facet, near, ball_of(beyond).from(cells_.mirror_index(cell, side)));
    }
  }

  void wait(const Facet& facet, const BallEstimate& near) {
    waiting_.push_back({facet, near});
    if (waiting_.size() == kMostWaiting) decide_waiting();
  }

  void decide_waiting() {
    beyond_.clear();
    for (const WaitingFacet& w : waiting_) {
      const CellId beyond = cells_.neighbor(w.facet.cell, w.facet.side);
      if (!cells_.is_infinite(beyond)) beyond_.push_back(beyond);
    }
    estimator_.estimate(beyond_, beyond_balls_);
    std::size_t i = 0;
    for (const WaitingFacet& w : waiting_) {
      const CellId beyond = cells_.neighbor(w.facet.cell, w.facet.side);
      const bool is_hull = cells_.is_infinite(beyond);
      decide(w.facet, w.near,
             is_hull ? BallEstimate{}
                     : beyond_balls_[i].from(cells_.mirror_index(w.facet.cell, w.facet.side)));
      i += is_hull ? 0 : 1;
    }
    waiting_.clear();
  }

  void decide(const Facet& facet, const BallEstimate& near, const BallEstimate& far) {
    const Verdict verdict = criterion_.judge(near, far);
    if (verdict != Verdict::kOut) take(facet, verdict == Verdict::kIn);
  }

  /// Takes the facet, unless the accurate balls have the last word and are against it.
  void take(Facet inner, bool is_sure) {
    Facet outer{cells_.neighbor(inner.cell, inner.side),
                cells_.mirror_index(inner.cell, inner.side)};
    if (cells_.is_infinite(inner.cell)) std::swap(inner, outer);
    const bool is_hull = cells_.is_infinite(outer.cell);
    const RankedFacet facet(window_, cells_.facet(inner.cell, inner.side));
    const FacetBalls balls = balls_beside(cells_, facet, inner.cell, inner.side);
    if (!is_sure && !criterion_.takes(balls)) return;
    FacetRecord record{facet.ranks, static_cast<float>(gamma_angle(balls)), output_.source};
    if (is_hull) record.facing = facet.reversed ? Facing::kInward : Facing::kOutward;
    taken_.push_back(record);
    if (taken_.size() == kMostTaken) hand_over();
  }

  void hand_over() {
    export_facets(taken_, output_.layout, output_.out);
    taken_.clear();
  }

  const FinalWindow& window_;
  const CellView cells_;
  const Criterion& criterion_;
  const Output output_;
  BallEstimator estimator_;
  CellId begin_ = 0;  ///< of the block
  CellId end_ = 0;
  std::vector<CellId> block_;         ///< its finite cells with an owned vertex
  std::vector<std::uint32_t> place_;  ///< in block_, by cell from begin_ on
  std::vector<CellBall> balls_;       ///< of block_
  std::vector<Facet> candidates_;
  std::size_t candidate_count_ = 0;
  std::vector<WaitingFacet> waiting_;
  std::vector<CellId> beyond_;
  std::array<CellBall, kMostWaiting> beyond_balls_;
  std::vector<FacetRecord> taken_;
};

}  // namespace

template <class Criterion>
void FacetFilter::filter(const FinalWindow& window, const Criterion& criterion, ExportWriter& out) {
  FacetPass<Criterion>(window, criterion, {source_, layout_, out}).run(stop_);
}

template void FacetFilter::filter(const FinalWindow&, const GammaCriterion&, ExportWriter&);
template void FacetFilter::filter(const FinalWindow&, const AlphaCriterion&, ExportWriter&);

}  // namespace stream_recon
