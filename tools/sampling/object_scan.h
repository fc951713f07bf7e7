// The walk over one object: its mask, smoothed or not, and the scan that finds its points.
//
// Memory: docs of MaskGrid, SmoothedMask and the scans. Thread rule: one user.
#pragma once

#include <memory>

#include "tools/sampling/mask_grid.h"
#include "tools/sampling/sampling.h"
#include "tools/sampling/slice_scan.h"
#include "tools/sampling/smoothed_mask.h"

namespace stream_recon {

struct ObjectScanOptions {
  PointKind kind = PointKind::kSmoothedBoundary;  ///< or kBoundaryVoxels
  MaskSmoothing smoothing;                        ///< as in SamplingOptions
  GridBox box;                                    ///< of the grid; may hold the object
};

/// Slices of the grid before which, and behind which, a step looks.
std::size_t slices_around(const ObjectScanOptions& options);

class ObjectScan {
 public:
  ObjectScan(RecentSlices& slices, const VoxelSelection& selection,
             const ObjectScanOptions& options, const GridPointConsumer& consume);

  /// Visits the next slice of the box, which has one more on either side; false at the end.
  bool step() { return scan_->step(); }

  SampleCounts counts() const;

  /// Estimate for a box, before one is built.
  static std::size_t memory_bytes(const ObjectScanOptions& options);

 private:
  MaskGrid mask_;
  std::unique_ptr<SmoothedMask> smoothed_;
  std::unique_ptr<SliceScan> scan_;
};

}  // namespace stream_recon
