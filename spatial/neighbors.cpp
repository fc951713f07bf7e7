#include "spatial/neighbors.h"

#include <flann/algorithms/dist.h>
#include <flann/algorithms/kdtree_single_index.h>

#include <algorithm>

#include "spatial/vector.h"

namespace stream_recon {
namespace {

/// Up to here looking at all of them is faster than a tree.
constexpr std::size_t kFewPoints = 32;

constexpr std::size_t kLeafPoints = 10;

using Index = flann::KDTreeSingleIndex<flann::L2_Simple<double>>;

static_assert(sizeof(Point3) == 3 * sizeof(double));

}  // namespace

struct Neighbors::Tree {
  // FLANN takes the points as not const, and copies them.
  explicit Tree(std::span<const Point3> points)
      : index(flann::Matrix<double>(const_cast<double*>(&points.data()->x), points.size(), 3),
              flann::KDTreeSingleIndexParams(kLeafPoints)) {
    index.buildIndex();
  }

  Index index;
};

Neighbors::Neighbors(std::span<const Point3> points)
    : points_(points),
      tree_(points.size() > kFewPoints ? std::make_unique<Tree>(points) : nullptr) {}

Neighbors::~Neighbors() = default;
Neighbors::Neighbors(Neighbors&&) noexcept = default;
Neighbors& Neighbors::operator=(Neighbors&&) noexcept = default;

std::vector<Neighbor> Neighbors::nearest(const Point3& place, std::size_t count) const {
  count = std::min(count, points_.size());
  std::vector<Neighbor> found;
  if (count == 0) return found;
  if (tree_) {
    flann::KNNSimpleResultSet<double> result(count);
    tree_->index.findNeighbors(result, &place.x,
                               flann::SearchParams(flann::FLANN_CHECKS_UNLIMITED));
    std::vector<std::size_t> indices(count);
    std::vector<double> distances(count);
    result.copy(indices.data(), distances.data(), count);
    for (std::size_t i = 0; i < count; ++i) {
      found.push_back({static_cast<std::uint32_t>(indices[i]), distances[i]});
    }
    std::sort(found.begin(), found.end());
    return found;
  }
  for (std::uint32_t i = 0; i < points_.size(); ++i) {
    const Point3 d = minus(place, points_[i]);
    found.push_back({i, dot(d, d)});
  }
  std::partial_sort(found.begin(), found.begin() + static_cast<std::ptrdiff_t>(count), found.end());
  found.resize(count);
  return found;
}

}  // namespace stream_recon
