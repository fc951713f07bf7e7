// Where the cells of a sampled grid lie: from its region, its slices' offsets and the volume.
//
// Guarantees: without offsets a cell lies exactly where the volume says its voxel lies, whatever
// the region. Between two slices their offsets are interpolated.
// Memory: 16 bytes a slice. Thread rule: immutable once built.
#pragma once

#include <array>
#include <vector>

#include "spatial/point.h"
#include "tools/sampling/aligned_grid.h"
#include "tools/sampling/grid.h"
#include "tools/sampling/slice_alignment.h"
#include "tools/sampling/slice_scan.h"
#include "tools/slices/volume.h"

namespace stream_recon {

enum class CoordinateSystem {
  kWorld,  ///< the volume's physical space: spacing, origin and direction
  kIndex,  ///< voxel numbers along i, j, k
};

struct PlacementOptions {
  GridBox region;                    ///< of the volume
  GridSize every{1, 1, 1};           ///< voxels from cell to cell
  std::vector<SliceOffset> offsets;  ///< one a slice of the volume, in voxels; empty: none
  CoordinateSystem coordinates = CoordinateSystem::kWorld;
};

class Placement {
 public:
  Placement(const VolumeGeometry& geometry, const PlacementOptions& options);

  /// The whole cells that each slice is moved by; empty without offsets.
  const std::vector<SliceShift>& shifts() const { return shifts_; }

  /// \param place in the (moved) grid
  Point3 position(const GridPoint& place) const;

  /// Distance from cell to cell along i, j, k, in the units of positions.
  std::array<double, 3> spacing() const;

 private:
  void plan_shifts();
  SliceOffset rest(double k) const;

  VolumeGeometry geometry_;
  PlacementOptions options_;
  std::vector<SliceShift> shifts_;
  std::vector<SliceOffset> rests_;  ///< of each slice, in voxels, beyond its shift
  std::array<double, 3> first_{};   ///< voxel number of cell 0
};

}  // namespace stream_recon
