#include "engine/spacing/neighbor_search.h"

#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

namespace stream_recon {
namespace {

using namespace index_layout;

/// How much farther than the leaf before a leaf looks at first, squared; the same again if that
/// was too near.
constexpr double kGuess = 1.2;
constexpr double kSecondGuess = 4 * kGuess;

double gap(int axis, const NodeBounds& a, const NodeBounds& b) {
  const double below = double{a.low[axis]} - b.high[axis];
  const double above = double{b.low[axis]} - a.high[axis];
  return std::max(0.0, std::max(below, above));
}

PointColumns columns(const PointPage& page, std::size_t offset) {
  return {&page.x[offset], &page.y[offset], &page.z[offset]};
}

/// The children of a node, the nearest first.
class Children {
 public:
  void add(double squared_gap, std::uint64_t child) {
    std::size_t at = count_++;
    for (; at > 0 && squared_gap < list_[at - 1].squared_gap; --at) list_[at] = list_[at - 1];
    list_[at] = {squared_gap, child};
  }

  struct Child {
    double squared_gap;
    std::uint64_t number;
  };
  std::span<const Child> list() const { return {list_.data(), count_}; }

 private:
  std::array<Child, kFanout> list_;
  std::size_t count_ = 0;
};

}  // namespace

// Conservative, as squared_gaps() is.
double NeighborSearch::squared_gap(const NodeBounds& bounds) const {
  const double x = gap(0, bounds, box_);
  const double y = gap(1, bounds, box_);
  const double z = gap(2, bounds, box_);
  return x * x + y * y + z * z;
}

// How far the leaf before had to look is a good guess, so that few points are offered in vain; a
// guess that is too near is noticed, one that is too far is corrected by the lists' bounds.
void NeighborSearch::search(LeafNumber leaf) {
  load(leaf);
  const double known = std::exchange(farthest_, 0);
  if (known > 0 && (search_within(kGuess * known) || search_within(kSecondGuess * known))) return;
  search_within(std::numeric_limits<double>::infinity());
}

void NeighborSearch::load(LeafNumber leaf) {
  leaf_ = leaf;
  const PointRank first = leaf * kLeafPoints;
  count_ = std::min(kLeafPoints, index_.point_count - first);
  const PointPage& page = pages_.points_at(first);
  const std::size_t offset = first % PointPage::kPoints;
  for (std::size_t i = 0; i < kLeafPoints; ++i) {
    const Point3 p = page.scaled_point(offset + i);
    relative_.x[i] = p.x - index_.origin.x;
    relative_.y[i] = p.y - index_.origin.y;
    relative_.z[i] = p.z - index_.origin.z;
    lists_[i].start(p, 0);
  }
  box_ = pages_.nodes(leaf / kPageLeaves)
             .nodes[kFirstLeaf + static_cast<std::uint32_t>(leaf % kPageLeaves)];
}

// For the points whose lists are not full yet; whether all are now. A list that is full has
// everything within its bound.
bool NeighborSearch::search_within(double squared_distance) {
  const PointRank first = leaf_ * kLeafPoints;
  const PointPage& page = pages_.points_at(first);
  const std::size_t offset = first % PointPage::kPoints;
  bound_ = 0;
  bounds_.fill(-1);
  for (std::size_t i = 0; i < count_; ++i) {
    if (lists_[i].is_full()) continue;
    lists_[i].start(page.scaled_point(offset + i), squared_distance);
    lists_[i].offer(columns(page, offset), first);
    bounds_[i] = lists_[i].bound();
    bound_ = squared_distance;
  }
  descend_top(index_.top.size() - 1, 0);
  return std::all_of(lists_.begin(), lists_.begin() + count_,
                     [](const NearestList& list) { return list.is_full(); });
}

void NeighborSearch::descend_top(std::size_t level, std::uint64_t node) {
  if (level == 0) {
    descend_page(node, 0);
    return;
  }
  const std::vector<NodeBounds>& below = index_.top[level - 1];
  const std::uint64_t end = std::min<std::uint64_t>(kFanout * (node + 1), below.size());
  Children children;
  for (std::uint64_t c = kFanout * node; c < end; ++c) children.add(squared_gap(below[c]), c);
  for (const auto& child : children.list()) {
    if (child.squared_gap > bound_) return;
    if (reaches(below[child.number])) descend_top(level - 1, child.number);
  }
}

void NeighborSearch::descend_page(std::uint64_t page, std::uint32_t node) {
  const NodePage& nodes = pages_.nodes(page);
  Children children;
  for (std::uint32_t c = 4 * node + 1; c <= 4 * node + 4; ++c) {
    if (!nodes.nodes[c].empty()) children.add(squared_gap(nodes.nodes[c]), c);
  }
  for (const auto& child : children.list()) {
    if (child.squared_gap > bound_) return;
    if (!reaches(nodes.nodes[child.number])) continue;
    const auto c = static_cast<std::uint32_t>(child.number);
    if (c < kFirstLeaf) {
      descend_page(page, c);
    } else {
      visit_leaf(leaves_below(page, c).begin);
    }
  }
}

// One box around all points of the leaf says little where the curve jumps between them.
bool NeighborSearch::reaches(const NodeBounds& bounds) {
  squared_gaps({relative_.x.data(), relative_.y.data(), relative_.z.data()}, bounds, gaps_);
  bool any = false;
  for (std::size_t i = 0; i < kLeafPoints; ++i) any |= gaps_[i] <= bounds_[i];
  return any;
}

/// \pre reaches() was asked about it last.
void NeighborSearch::visit_leaf(LeafNumber leaf) {
  if (leaf == leaf_) return;
  const PointRank first = leaf * kLeafPoints;
  const PointColumns points = columns(pages_.points_at(first), first % PointPage::kPoints);
  for (std::size_t i = 0; i < count_; ++i) {
    if (gaps_[i] > bounds_[i]) continue;
    lists_[i].offer(points, first);
    bounds_[i] = lists_[i].bound();
  }
  bound_ = *std::max_element(bounds_.begin(), bounds_.end());
}

std::span<const Point3> NeighborSearch::vectors(std::size_t i) {
  std::array<NearPoint, NearestList::kMost> near;
  const std::size_t count = lists_[i].sorted(near);
  farthest_ = std::max(farthest_, near[count - 1].squared_distance);
  const Point3 place = lists_[i].place();
  // The first is the point itself.
  for (std::size_t n = 1; n < count; ++n) {
    const PointPage& page = pages_.points_at(near[n].rank);
    const std::size_t at = near[n].rank % PointPage::kPoints;
    vectors_[n - 1] = {page.x[at] - place.x, page.y[at] - place.y, page.z[at] - place.z};
  }
  return {vectors_.data(), count - 1};
}

}  // namespace stream_recon
