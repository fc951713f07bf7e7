#include "engine/windows/certificate_search.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "spatial/vector.h"

namespace stream_recon {
namespace {

using namespace index_layout;

/// In the lists, half-spaces have numbers from here on.
constexpr std::uint32_t kFirstHalfSpace = BallList::kMost;

// The radius that no point in conflict is beyond, by the rounding of the ball itself and of the
// coordinates of points and bounds.
double search_radius(const Circumball& ball, double reach) {
  const double radius = ball.radius();
  return (radius + ball.centre_error + 2e-14 * (radius + 4 * reach)) * (1 + 1e-14);
}

/// The top, the pages, and the list that a page begins with.
std::size_t depth_of(const CloudIndex& index) {
  return index.top.size() + 6;
}

const NodeBounds& root_of(const CloudIndex& index) {
  return index.top.back().front();
}

}  // namespace

std::uint64_t CertificateSearch::memory(const CloudIndex& index) {
  return depth_of(index) * sizeof(BallList) +
         kMostCells * (sizeof(BallQuery) + sizeof(HalfSpaceQuery));
}

CertificateSearch::CertificateSearch(const CloudIndex& index, IndexReader& reader)
    : index_(index), reader_(reader), top_frame_(root_of(index)), frame_(top_frame_) {
  balls_.reserve(kMostCells);
  half_spaces_.reserve(kMostCells);
  for (std::size_t i = 0; i < depth_of(index); ++i) lists_.push_back(std::make_unique<BallList>());
}

void CertificateSearch::search(const Delaunay& delaunay, const Scope& scope,
                               std::span<const CellId> cells, std::span<LeafNumber> conflicts) {
  delaunay_ = &delaunay;
  present_ = &scope.present;
  first_leaf_ = scope.first_leaf;
  conflicts_ = conflicts;
  balls_.clear();
  half_spaces_.clear();
  frame_ = top_frame_;
  lists_[0]->count = 0;
  for (std::size_t i = 0; i < cells.size(); ++i) add_query(cells[i], static_cast<std::uint32_t>(i));
  counts_.queries += cells.size();
  if (!cells.empty()) descend_top(index_.top.size() - 1, 0, 0);
}

void CertificateSearch::add_query(CellId cell, std::uint32_t place) {
  conflicts_[place] = kFinal;
  const auto v = delaunay_->vertices(cell);
  std::array<Point3, 4> corners;
  for (int i = 0; i < 3; ++i) corners[i] = delaunay_->point(v[i]);
  std::uint32_t id = 0;
  if (v[3] == Delaunay::kInfinite) {
    id = kFirstHalfSpace + static_cast<std::uint32_t>(half_spaces_.size());
    half_spaces_.push_back(
        {place, cell, HalfSpace({corners[0], corners[1], corners[2]}, index_), 0});
  } else {
    corners[3] = delaunay_->point(v[3]);
    for (Point3& p : corners) p = scaled(p, index_.scale);
    const Circumball ball = circumball(corners);
    const double radius = search_radius(ball, index_.reach);
    id = static_cast<std::uint32_t>(balls_.size());
    balls_.push_back({place, cell, ball, plus(minus(ball.origin, index_.origin), ball.centre),
                      radius * radius, 0});
  }
  lists_[0]->push(region(id, frame_), id);
}

Region CertificateSearch::region(std::uint32_t id, const ListFrame& frame) const {
  if (id < kFirstHalfSpace) return ball_in(frame, balls_[id].centre, balls_[id].squared);
  const HalfSpaceQuery& query = half_spaces_[id - kFirstHalfSpace];
  return query.half_space.at_least(query.best, frame);
}

// Fills the list of the next depth with the cells whose regions reach the node; whether there are
// any.
bool CertificateSearch::narrow(const NodeBounds& bounds, const LeafRange& leaves,
                               std::size_t depth) {
  if (bounds.empty() || leaves.end <= first_leaf_ || present_->has_leaves(leaves)) return false;
  counts_.node_visits += lists_[depth]->count;
  touching(*lists_[depth], bounds, frame_, *lists_[depth + 1]);
  return lists_[depth + 1]->count > 0;
}

void CertificateSearch::descend_top(std::size_t level, std::uint64_t node, std::size_t depth) {
  if (level == 0) {
    enter_page(node, depth);
    return;
  }
  const std::uint64_t end =
      std::min<std::uint64_t>(kFanout * (node + 1), index_.top[level - 1].size());
  for (std::uint64_t child = kFanout * node; child < end; ++child) {
    if (narrow(index_.top[level - 1][child], leaves_below_top(level - 1, child), depth)) {
      descend_top(level - 1, child, depth + 1);
    }
  }
}

// Describes the regions anew: as closely to the page as floats allow, and without what conflicts
// found since have cut off.
void CertificateSearch::enter_page(std::uint64_t page, std::size_t depth) {
  frame_ = ListFrame(index_.top[0][page]);
  const BallList& from = *lists_[depth];
  BallList& to = *lists_[depth + 1];
  to.count = 0;
  for (std::size_t i = 0; i < from.count; ++i) to.push(region(from.id[i], frame_), from.id[i]);
  nodes_ = &reader_.nodes(page);
  descend_page(page, 0, depth + 1);
  frame_ = top_frame_;
}

void CertificateSearch::descend_page(std::uint64_t page, std::uint32_t node, std::size_t depth) {
  for (std::uint32_t child = 4 * node + 1; child <= 4 * node + 4; ++child) {
    const LeafRange leaves = leaves_below(page, child);
    if (!narrow(nodes_->nodes[child], leaves, depth)) continue;
    if (child >= kFirstLeaf) {
      search_leaf(leaves.begin, *lists_[depth + 1]);
    } else {
      descend_page(page, child, depth + 1);
    }
  }
}

void CertificateSearch::search_leaf(LeafNumber leaf, const BallList& balls) {
  const PointRank first = leaf * kLeafPoints;
  const Leaf points{leaf, reader_.points_at(first), first % PointPage::kPoints};
  for (std::size_t i = 0; i < balls.count; ++i) {
    const std::uint32_t id = balls.id[i];
    if (id < kFirstHalfSpace) {
      search_leaf(points, balls_[id]);
    } else {
      search_leaf(points, half_spaces_[id - kFirstHalfSpace]);
    }
  }
}

void CertificateSearch::search_leaf(const Leaf& leaf, BallQuery& query) {
  const PointPage& page = leaf.page;
  powers_of_points(query.ball, {&page.x[leaf.offset], &page.y[leaf.offset], &page.z[leaf.offset]},
                   powers_);
  if (!(powers_.least < query.best)) return;
  LeafNumber& conflict = conflicts_[query.place];
  for (std::size_t i = 0; i < kLeafPoints; ++i) {
    const double power = powers_.power[i];
    const double error = powers_.error[i];
    if (!(power - error < query.best)) continue;
    if (conflict != kFinal && power >= query.best) continue;
    if (present_->is_single(leaf.number * kLeafPoints + i)) continue;
    const bool is_certain = power + error < 0;
    if (!is_certain && !delaunay_->in_conflict(query.cell, page.point(leaf.offset + i))) continue;
    conflict = leaf.number;
    query.best = std::min(query.best, power);
  }
  const double radius = search_radius(query.ball, index_.reach);
  query.squared = std::max(0.0, radius * radius + query.best);
}

void CertificateSearch::search_leaf(const Leaf& leaf, HalfSpaceQuery& query) {
  const PointRank first = leaf.number * kLeafPoints;
  const std::uint64_t count = std::min(kLeafPoints, index_.point_count - first);
  LeafNumber& conflict = conflicts_[query.place];
  for (std::size_t i = 0; i < count; ++i) {
    const auto [height, error] = query.half_space.height(leaf.page.scaled_point(leaf.offset + i));
    if (height + error < query.best || (conflict != kFinal && height <= query.best)) continue;
    if (present_->is_single(first + i)) continue;
    const bool is_certain = height > error;
    if (!is_certain && !delaunay_->in_conflict(query.cell, leaf.page.point(leaf.offset + i))) {
      continue;
    }
    conflict = leaf.number;
    query.best = std::max(query.best, height);
  }
}

}  // namespace stream_recon
