// Some points of the cloud by rank, with predicates that are exact for them.
//
// Thread rule: const for many. Memory: 32 bytes a point. Cost: a binary search a point.
#pragma once

#include <algorithm>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "engine/windows/final_window.h"
#include "spatial/predicates.h"

namespace stream_recon {

class RankedPoints {
 public:
  /// \param ranks ascending \param points of each
  RankedPoints(std::vector<PointRank> ranks, std::vector<Point3> points);

  /// Multiplied by a power of two that is the same for all. \pre the rank is there
  const Point3& at(PointRank rank) const {
    const auto found = std::lower_bound(ranks_.begin(), ranks_.end(), rank);
    return points_[static_cast<std::size_t>(found - ranks_.begin())];
  }
  const Predicates& predicates() const { return predicates_; }

 private:
  std::vector<PointRank> ranks_;
  std::vector<Point3> points_;
  Predicates predicates_;
};

}  // namespace stream_recon
