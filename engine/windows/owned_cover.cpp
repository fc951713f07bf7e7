#include "engine/windows/owned_cover.h"

#include <algorithm>

namespace stream_recon {
namespace {

using namespace index_layout;

constexpr std::uint64_t kFirstBoxes = 64;

/// A part of the owned points and a box around it.
struct Part {
  double squared_size = 0;
  NodeBounds bounds{};
  PointRank first = 0;
  std::uint64_t points = 0;  ///< of the node, a power of four times 16; 1 for a point

  friend bool operator<(const Part& a, const Part& b) { return a.squared_size < b.squared_size; }
};

/// Boxes around the owned points, the largest divided first: where a run of the curve jumps, its
/// box would else make half of the cloud a neighbour.
class OwnedCover {
 public:
  OwnedCover(const CloudIndex& index, IndexReader& reader, const OwnedRange& owned)
      : index_(index), reader_(reader), owned_(owned) {
    std::uint64_t points = kLeafPoints;
    while (owned.count / points > kFirstBoxes) points *= kFanout;
    for (PointRank first = owned.first / points * points; first < owned.end(); first += points) {
      add(first, points);
    }
    while (parts_.size() < kMostCoverBoxes && parts_.front().points > 1) divide();
  }

  std::vector<NodeBounds> boxes() const {
    std::vector<NodeBounds> boxes;
    for (const Part& part : parts_) boxes.push_back(part.bounds);
    return boxes;
  }

 private:
  void add(PointRank first, std::uint64_t points) {
    if (first >= owned_.end() || first + points <= owned_.first) return;
    const NodeBounds bounds = bounds_of(first, points);
    parts_.push_back({squared_diagonal(bounds), bounds, first, points});
    std::push_heap(parts_.begin(), parts_.end());
  }

  void divide() {
    std::pop_heap(parts_.begin(), parts_.end());
    const Part part = parts_.back();
    parts_.pop_back();
    const std::uint64_t step = part.points == kLeafPoints ? 1 : part.points / kFanout;
    for (PointRank first = part.first; first < part.first + part.points; first += step) {
      add(first, step);
    }
  }

  NodeBounds bounds_of(PointRank first, std::uint64_t points) {
    if (points == 1) {
      const PointPage& page = reader_.points_at(first);
      const Point3 p = page.scaled_point(first % PointPage::kPoints);
      const Point3& o = index_.origin;
      const Point3 relative{p.x - o.x, p.y - o.y, p.z - o.z};
      return bounds_of_points({&relative, 1}, index_.reach);
    }
    if (points < kPagePoints) {
      std::uint32_t level_first = kFirstLeaf;
      for (std::uint64_t p = kLeafPoints; p < points; p *= kFanout) {
        level_first = (level_first - 1) / 4;
      }
      const auto within = static_cast<std::uint32_t>(first % kPagePoints / points);
      return reader_.nodes(first / kPagePoints).nodes[level_first + within];
    }
    std::size_t level = 0;
    for (std::uint64_t p = kPagePoints; p < points; p *= kFanout) ++level;
    return index_.top[level][first / points];
  }

  const CloudIndex& index_;
  IndexReader& reader_;
  const OwnedRange& owned_;
  std::vector<Part> parts_;  ///< a heap
};

}  // namespace

std::vector<NodeBounds> cover_owned(const CloudIndex& index, IndexReader& reader,
                                    const OwnedRange& owned) {
  return OwnedCover(index, reader, owned).boxes();
}

}  // namespace stream_recon
