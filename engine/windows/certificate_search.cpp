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

/// Of balls that are taken for half-spaces the centres are nearer to that of the sphere than a
/// quarter of its radius: the square of twice that.
constexpr double kNearSphere = 0.25;

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
  std::uint32_t id = 0;
  if (delaunay_->is_infinite(cell)) {
    const auto v = delaunay_->vertices(cell);
    id = kFirstHalfSpace + static_cast<std::uint32_t>(half_spaces_.size());
    half_spaces_.push_back(
        {place, cell,
         HalfSpace({delaunay_->point(v[0]), delaunay_->point(v[1]), delaunay_->point(v[2])},
                   index_),
         0});
  } else {
    const Circumball ball = circumball(scaled_corners(cell));
    const double radius = search_radius(ball, index_.reach);
    id = static_cast<std::uint32_t>(balls_.size());
    balls_.push_back({place, cell, ball, plus(minus(ball.origin, index_.origin), ball.centre),
                      radius * radius, 0});
  }
  lists_[0]->push(region(id, index_.shells.cloud), id);
}

std::array<Point3, 4> CertificateSearch::scaled_corners(CellId cell) const {
  const auto v = delaunay_->vertices(cell);
  std::array<Point3, 4> corners;
  for (int i = 0; i < 4; ++i) corners[i] = scaled(delaunay_->point(v[i]), index_.scale);
  return corners;
}

/// In the frame at work. \param shell of the points to be asked about
Region CertificateSearch::region(std::uint32_t id, const Shell& shell) {
  if (id >= kFirstHalfSpace) {
    const HalfSpaceQuery& query = half_spaces_[id - kFirstHalfSpace];
    return query.half_space.at_least(query.best, frame_);
  }
  BallQuery& query = balls_[id];
  if (shell.exists()) {
    if (const auto cut = cut_region(query, shell)) return *cut;
  }
  return ball_in(frame_, query.centre, query.squared);
}

/// The half-space that the ball is for the points of a shell, if it tells more than the ball.
std::optional<Region> CertificateSearch::cut_region(BallQuery& query, const Shell& shell) {
  const Sphere& sphere = index_.shells.spheres[shell.sphere];
  if (query.sphere != shell.sphere) {
    query.sphere = shell.sphere;
    query.cut = cut_sphere(sphere, scaled_corners(query.cell));
  }
  const SphereCut& cut = query.cut;
  if (!cut.is_known()) return std::nullopt;
  const double size = length(cut.gradient);
  // A ball much smaller than the sphere is not all of its half-space within the shell.
  if (!(size > 0) || size * size > kNearSphere * sphere.squared_radius) return std::nullopt;
  const Point3 corner = minus(cut.origin, index_.origin);
  const double distance = length(minus(frame_.origin, corner)) + frame_.unit;
  const double least = cut.at_origin + shell.low - query.best -
                       cut.error(2 * (distance + index_.reach)) -
                       2 * height_error(sphere, shell.low);
  const Point3 normal = scaled(cut.gradient, -1 / size);
  return half_space_in(frame_, normal, dot(normal, corner) + least / size);
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
  const Shell& shell = index_.shells.pages[page];
  const BallList& from = *lists_[depth];
  BallList& to = *lists_[depth + 1];
  to.count = 0;
  for (std::size_t i = 0; i < from.count; ++i) to.push(region(from.id[i], shell), from.id[i]);
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

void CertificateSearch::Leaf::set_heights(std::uint32_t number_of, const Sphere& of) {
  if (sphere == number_of) return;
  sphere = number_of;
  for (std::size_t i = 0; i < kLeafPoints; ++i) {
    heights[i] = height_over(of, page.scaled_point(offset + i));
  }
}

void CertificateSearch::search_leaf(LeafNumber leaf, const BallList& balls) {
  const PointRank first = leaf * kLeafPoints;
  Leaf points{leaf, reader_.points_at(first), first % PointPage::kPoints};
  for (std::size_t i = 0; i < balls.count; ++i) {
    const std::uint32_t id = balls.id[i];
    if (id < kFirstHalfSpace) {
      search_leaf(points, balls_[id]);
    } else {
      search_leaf(points, half_spaces_[id - kFirstHalfSpace]);
    }
  }
}

void CertificateSearch::search_leaf(Leaf& leaf, BallQuery& query) {
  const PointPage& page = leaf.page;
  powers_of_points(query.ball, leaf.columns(), powers_);
  if (!(powers_.least < query.best)) return;
  // Also in a page without a shell there may be points of the sphere.
  if (query.sphere != Shell::kNone && query.cut.is_known()) {
    const Sphere& sphere = index_.shells.spheres[query.sphere];
    leaf.set_heights(query.sphere, sphere);
    sharpen_powers(sphere, query.cut, leaf.columns(), leaf.heights, powers_);
    if (!(powers_.least < query.best)) return;
  }
  LeafNumber& conflict = conflicts_[query.place];
  for (std::size_t i = 0; i < kLeafPoints; ++i) {
    const double power = powers_.power[i];
    const double error = powers_.error[i];
    if (!(power - error < query.best)) continue;
    if (conflict != kFinal && power >= query.best) continue;
    if (present_->is_single(leaf.number * kLeafPoints + i)) continue;
    const bool is_certain = power + error < 0;
    counts_.exact_tests += is_certain ? 0 : 1;
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
    if (!is_certain && query.half_space.is_beside_circle(leaf.page.scaled_point(leaf.offset + i))) {
      continue;
    }
    counts_.exact_tests += is_certain ? 0 : 1;
    if (!is_certain && !delaunay_->in_conflict(query.cell, leaf.page.point(leaf.offset + i))) {
      continue;
    }
    conflict = leaf.number;
    query.best = std::max(query.best, height);
  }
}

}  // namespace stream_recon
