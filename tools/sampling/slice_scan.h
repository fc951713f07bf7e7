// One walk over a grid that hands out points, a slice at a time.
//
// Thread rule: one user.
#pragma once

#include <cstdint>
#include <functional>

#include "spatial/point.h"

namespace stream_recon {

/// Takes a position in cells of the scanned grid.
using CellConsumer = std::function<void(const Point3&)>;

class SliceScan {
 public:
  virtual ~SliceScan() = default;

  /// Visits the next slice; false once there is none. \throw what the grid throws
  virtual bool step() = 0;

  /// Visits all slices that are left; returns the number of points of the whole walk.
  std::uint64_t run() {
    while (step()) {
    }
    return points_;
  }

  std::uint64_t points() const { return points_; }

 protected:
  std::uint64_t points_ = 0;
};

}  // namespace stream_recon
