// An axis-aligned box; empty (low > high) until it is extended.
#pragma once

#include <algorithm>
#include <limits>

#include "spatial/point.h"

namespace stream_recon {

struct Box3 {
  Point3 low{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity(),
             std::numeric_limits<double>::infinity()};
  Point3 high{-std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity(),
              -std::numeric_limits<double>::infinity()};

  bool empty() const { return !(low.x <= high.x); }

  void extend(const Point3& p) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }

  /// Longest side; 0 for an empty box. Infinite where the sides overflow a double.
  double extent() const {
    if (empty()) return 0;
    return std::max({high.x - low.x, high.y - low.y, high.z - low.z});
  }
};

}  // namespace stream_recon
