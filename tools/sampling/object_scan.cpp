#include "tools/sampling/object_scan.h"

#include "tools/sampling/boundary_voxel_scan.h"
#include "tools/sampling/iso_scan.h"

namespace stream_recon {
namespace {

constexpr double kBoundary = 0.5;

bool is_smoothed(const ObjectScanOptions& options) {
  return options.kind == PointKind::kSmoothedBoundary && options.smoothing.sigma > 0;
}

/// Moves places in the padded box to places in the grid.
GridPointConsumer in_grid(const GridBox& box, const GridPointConsumer& consume) {
  const Point3 corner{static_cast<double>(box.low[0]) - 1, static_cast<double>(box.low[1]) - 1,
                      static_cast<double>(box.low[2]) - 1};
  return [corner, consume](const GridPoint& p) {
    consume({{corner.x + p.cell.x, corner.y + p.cell.y, corner.z + p.cell.z}, p.fraction});
  };
}

}  // namespace

std::size_t slices_around(const ObjectScanOptions& options) {
  return 1 + (is_smoothed(options) ? blur_radius(options.smoothing.sigma) : 0);
}

ObjectScan::ObjectScan(RecentSlices& slices, const VoxelSelection& selection,
                       const ObjectScanOptions& options, const GridPointConsumer& consume)
    : mask_(slices, selection, options.box, slices_around(options) + 2) {
  if (options.kind == PointKind::kBoundaryVoxels) {
    scan_ = std::make_unique<BoundaryVoxelScan>(mask_, in_grid(options.box, consume));
    return;
  }
  if (is_smoothed(options)) smoothed_ = std::make_unique<SmoothedMask>(mask_, options.smoothing);
  Grid& field = smoothed_ ? static_cast<Grid&>(*smoothed_) : mask_;
  scan_ = std::make_unique<IsoScan>(field, kBoundary, in_grid(options.box, consume));
}

SampleCounts ObjectScan::counts() const {
  SampleCounts counts{scan_->points(), mask_.cells_inside()};
  if (smoothed_) {
    counts.voxels_lost = smoothed_->cells_lost();
    counts.voxels_gained = smoothed_->cells_gained();
  }
  return counts;
}

std::size_t ObjectScan::memory_bytes(const ObjectScanOptions& options) {
  const std::size_t cells = (options.box.extent(0) + 2) * (options.box.extent(1) + 2);
  std::size_t bytes_a_cell = slices_around(options) + 2;  // of the mask
  if (options.kind == PointKind::kSmoothedBoundary) bytes_a_cell += 3 * sizeof(double);
  if (is_smoothed(options)) {
    bytes_a_cell += (2 * blur_radius(options.smoothing.sigma) + 3) * sizeof(float) + sizeof(double);
  }
  return cells * bytes_a_cell;
}

}  // namespace stream_recon
