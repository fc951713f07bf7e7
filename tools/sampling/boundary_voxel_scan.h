// The centres of the object's cells that have one of their six face neighbours outside.
//
// Guarantees: points come in the order of their cells (i fastest). Thread rule: one user.
#pragma once

#include "tools/sampling/mask_grid.h"
#include "tools/sampling/slice_scan.h"

namespace stream_recon {

class BoundaryVoxelScan : public SliceScan {
 public:
  /// \pre the mask keeps at least 3 slices
  BoundaryVoxelScan(MaskGrid& mask, GridPointConsumer consume)
      : mask_(mask), consume_(std::move(consume)) {}

  bool step() override;

 private:
  MaskGrid& mask_;
  GridPointConsumer consume_;
  std::size_t k_ = 0;
};

}  // namespace stream_recon
