#include "engine/windows/half_space_search.h"

#include <algorithm>
#include <cmath>

namespace stream_recon {
namespace {

using namespace index_layout;

constexpr double kRoundoff = 0x1p-53;

Point3 minus(const Point3& a, const Point3& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
Point3 scaled(const Point3& p, double scale) {
  return {p.x * scale, p.y * scale, p.z * scale};
}
double dot(const Point3& a, const Point3& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
Point3 cross(const Point3& a, const Point3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
double length(const Point3& a) {
  return std::sqrt(dot(a, a));
}

// Both are the largest of normal.(p - corner) over what bounds a node, but for rounding.
double highest_in_box(const NodeBounds& box, const Point3& normal, const Point3& corner) {
  return normal.x * ((normal.x > 0 ? box.high[0] : box.low[0]) - corner.x) +
         normal.y * ((normal.y > 0 ? box.high[1] : box.low[1]) - corner.y) +
         normal.z * ((normal.z > 0 ? box.high[2] : box.low[2]) - corner.z);
}

double highest_in_disc(const NodeFrame& node, const Point3& normal, double normal_length,
                       const Point3& corner) {
  const double cosine = dot(normal, node.normal) * node.inverse_normal_squared;
  const double rest = normal_length * normal_length - cosine * cosine / node.inverse_normal_squared;
  const double sine = std::sqrt(std::max(0.0, rest) + 1e-14 * normal_length * normal_length);
  return dot(normal, minus(node.middle, corner)) +
         std::max(cosine * node.slab_low, cosine * node.slab_high) + sine * node.radius;
}

}  // namespace

std::optional<LeafNumber> HalfSpaceSearch::search(const Delaunay& delaunay,
                                                  const PresentPoints& present, CellId cell) {
  delaunay_ = &delaunay;
  present_ = &present;
  cell_ = cell;
  const auto v = delaunay.vertices(cell);
  corner_ = scaled(delaunay.point(v[0]), index_.scale);
  const Point3 u = minus(scaled(delaunay.point(v[1]), index_.scale), corner_);
  const Point3 w = minus(scaled(delaunay.point(v[2]), index_.scale), corner_);
  corner_relative_ = minus(corner_, index_.origin);
  normal_ = cross(u, w);
  normal_length_ = length(normal_);
  normal_error_ = 16 * kRoundoff * length(u) * length(w);
  best_ = 0;
  conflict_.reset();
  const std::size_t root = index_.top.size() - 1;
  if (may_reach(index_.top[root][0], {0, index_.leaf_count()})) descend_top(root, 0);
  return conflict_;
}

bool HalfSpaceSearch::may_reach(const NodeBounds& bounds, const LeafRange& leaves) {
  ++node_visits_;
  if (bounds.empty()) return false;
  const double slack = 4 * index_.reach * (2 * normal_error_ + 16 * kRoundoff * normal_length_);
  if (highest_in_box(bounds, normal_, corner_relative_) + slack < best_) return false;
  if (present_->has_leaves(leaves)) return false;
  const double height =
      highest_in_disc(NodeFrame(bounds), normal_, normal_length_, corner_relative_);
  return height + slack >= best_;
}

void HalfSpaceSearch::descend_top(std::size_t level, std::uint64_t node) {
  if (level == 0) {
    descend_page(node, 0);
    return;
  }
  const std::uint64_t end =
      std::min<std::uint64_t>(kFanout * (node + 1), index_.top[level - 1].size());
  for (std::uint64_t child = kFanout * node; child < end; ++child) {
    if (may_reach(index_.top[level - 1][child], leaves_below_top(level - 1, child))) {
      descend_top(level - 1, child);
    }
  }
}

void HalfSpaceSearch::descend_page(std::uint64_t page, std::uint32_t node) {
  for (std::uint32_t child = 4 * node + 1; child <= 4 * node + 4; ++child) {
    const LeafRange leaves = leaves_below(page, child);
    if (!may_reach(reader_.nodes(page).nodes[child], leaves)) continue;
    if (child >= kFirstLeaf) {
      search_leaf(leaves.begin);
    } else {
      descend_page(page, child);
    }
  }
}

void HalfSpaceSearch::search_leaf(LeafNumber leaf) {
  const PointRank first = leaf * kLeafPoints;
  const PointPage& page = reader_.points_at(first);
  const std::size_t offset = first % PointPage::kPoints;
  const std::uint64_t count = std::min(kLeafPoints, index_.point_count - first);
  for (std::size_t i = 0; i < count; ++i) {
    const Point3 q = minus(page.scaled_point(offset + i), corner_);
    const double height = dot(normal_, q);
    const double error = (normal_error_ + 16 * kRoundoff * normal_length_) *
                         (std::abs(q.x) + std::abs(q.y) + std::abs(q.z));
    if (height + error < best_ || (conflict_ && height <= best_)) continue;
    if (present_->is_single(first + i)) continue;
    if (height <= error && !delaunay_->in_conflict(cell_, page.point(offset + i))) continue;
    conflict_ = leaf;
    best_ = std::max(best_, height);
  }
}

}  // namespace stream_recon
