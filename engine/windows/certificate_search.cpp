#include "engine/windows/certificate_search.h"

#include <algorithm>
#include <cmath>

namespace stream_recon {
namespace {

using namespace index_layout;

Point3 minus(const Point3& a, const Point3& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}

// The radius that no point in conflict is beyond, by the rounding of the ball itself and of the
// distances that touching() computes.
double search_radius(const Circumball& ball, double reach) {
  const double radius = ball.radius();
  return (radius + ball.centre_error + 2e-14 * (radius + 4 * reach)) * (1 + 1e-14);
}

}  // namespace

CertificateSearch::CertificateSearch(const CloudIndex& index, IndexReader& reader)
    : index_(index), reader_(reader), half_spaces_(index, reader) {
  queries_.reserve(kMostCells);
  const std::size_t depth = index.top.size() + 5;
  for (std::size_t i = 0; i < depth; ++i) lists_.push_back(std::make_unique<BallList>());
  refreshed_.resize(depth);
}

void CertificateSearch::search(const Delaunay& delaunay, const PresentPoints& present,
                               std::span<const CellId> cells, std::span<LeafNumber> conflicts) {
  delaunay_ = &delaunay;
  present_ = &present;
  queries_.clear();
  BallList& all = *lists_[0];
  all.count = 0;
  refreshed_[0] = conflicts_found_;
  const std::uint64_t visits_before = half_spaces_.node_visits();
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (delaunay.is_infinite(cells[i])) {
      conflicts[i] = half_spaces_.search(delaunay, present, cells[i]).value_or(kFinal);
      queries_.push_back({cells[i], {}, 0, 0, conflicts[i]});
    } else {
      add_query(cells[i]);
    }
  }
  counts_.queries += cells.size();
  counts_.node_visits += half_spaces_.node_visits() - visits_before;
  const std::size_t root = index_.top.size() - 1;
  if (all.count > 0) descend_top(root, 0, 0);
  for (std::size_t i = 0; i < cells.size(); ++i) conflicts[i] = queries_[i].conflict;
}

void CertificateSearch::add_query(CellId cell) {
  const auto v = delaunay_->vertices(cell);
  std::array<Point3, 4> corners;
  for (int i = 0; i < 4; ++i) {
    const Point3 p = delaunay_->point(v[i]);
    corners[i] = {p.x * index_.scale, p.y * index_.scale, p.z * index_.scale};
  }
  const Circumball ball = circumball(corners);
  const double radius = search_radius(ball, index_.reach);
  const auto id = static_cast<std::uint32_t>(queries_.size());
  queries_.push_back({cell, ball, radius * radius, 0, kFinal});
  const Point3 start = minus(ball.origin, index_.origin);
  lists_[0]->push({start.x + ball.centre.x, start.y + ball.centre.y, start.z + ball.centre.z},
                  queries_.back().squared, id);
}

// Takes into account what leaves found since the list was made.
void CertificateSearch::refresh(std::size_t depth) {
  if (refreshed_[depth] == conflicts_found_) return;
  refreshed_[depth] = conflicts_found_;
  BallList& balls = *lists_[depth];
  for (std::size_t i = 0; i < balls.count; ++i) balls.squared[i] = queries_[balls.id[i]].squared;
}

// Fills the list of the next depth with the balls that reach the node; whether there are any.
bool CertificateSearch::narrow(const NodeBounds& bounds, const LeafRange& leaves,
                               std::size_t depth) {
  if (bounds.empty() || present_->has_leaves(leaves)) return false;
  counts_.node_visits += lists_[depth]->count;
  refreshed_[depth + 1] = refreshed_[depth];
  touching(*lists_[depth], NodeFrame(bounds), *lists_[depth + 1]);
  return lists_[depth + 1]->count > 0;
}

void CertificateSearch::descend_top(std::size_t level, std::uint64_t node, std::size_t depth) {
  if (level == 0) {
    descend_page(node, 0, depth);
    return;
  }
  const std::uint64_t end =
      std::min<std::uint64_t>(kFanout * (node + 1), index_.top[level - 1].size());
  for (std::uint64_t child = kFanout * node; child < end; ++child) {
    refresh(depth);
    if (narrow(index_.top[level - 1][child], leaves_below_top(level - 1, child), depth)) {
      descend_top(level - 1, child, depth + 1);
    }
  }
}

void CertificateSearch::descend_page(std::uint64_t page, std::uint32_t node, std::size_t depth) {
  for (std::uint32_t child = 4 * node + 1; child <= 4 * node + 4; ++child) {
    const LeafRange leaves = leaves_below(page, child);
    refresh(depth);
    if (!narrow(reader_.nodes(page).nodes[child], leaves, depth)) continue;
    if (child >= kFirstLeaf) {
      search_leaf(leaves.begin, *lists_[depth + 1]);
    } else {
      descend_page(page, child, depth + 1);
    }
  }
}

void CertificateSearch::search_leaf(LeafNumber leaf, const BallList& balls) {
  const PointRank first = leaf * kLeafPoints;
  const PointPage& page = reader_.points_at(first);
  const std::size_t offset = first % PointPage::kPoints;
  const PointColumns columns{&page.x[offset], &page.y[offset], &page.z[offset]};
  for (std::size_t i = 0; i < balls.count; ++i) {
    Query& query = queries_[balls.id[i]];
    powers_of_points(query.ball, columns, powers_);
    if (powers_.least < query.best) look_closer(query, leaf, page);
  }
}

void CertificateSearch::look_closer(Query& query, LeafNumber leaf, const PointPage& page) {
  const PointRank first = leaf * kLeafPoints;
  const std::size_t offset = first % PointPage::kPoints;
  for (std::size_t i = 0; i < kLeafPoints; ++i) {
    const double power = powers_.power[i];
    const double error = powers_.error[i];
    if (!(power - error < query.best)) continue;
    if (query.conflict != kFinal && power >= query.best) continue;
    if (present_->is_single(first + i)) continue;
    const bool is_certain = power + error < 0;
    if (!is_certain && !delaunay_->in_conflict(query.cell, page.point(offset + i))) continue;
    query.conflict = leaf;
    ++conflicts_found_;
    query.best = std::min(query.best, power);
  }
  const double radius = search_radius(query.ball, index_.reach);
  query.squared = std::max(0.0, radius * radius + query.best);
}

}  // namespace stream_recon
