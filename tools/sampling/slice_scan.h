// One walk over a grid that hands out points, a slice at a time.
//
// Thread rule: one user.
#pragma once

#include <cstdint>
#include <functional>

#include "spatial/point.h"

namespace stream_recon {

/// A place in a grid: a cell, whose numbers may be moved exactly, and how far it lies beyond it.
struct GridPoint {
  Point3 cell;      ///< whole numbers
  Point3 fraction;  ///< each in [0, 1)
};

using GridPointConsumer = std::function<void(const GridPoint&)>;

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
