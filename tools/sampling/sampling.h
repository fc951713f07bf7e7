// From a volume to points: the door to this folder.
//
// Guarantees: points are a function of the volume and the options; their order too. Nothing is
// dropped in silence: an object that yields no point is refused with what the volume has instead.
// Memory: a few slices, 8 bytes a voxel each, and 4 bytes for each of the 6 sigma + 1 slices that
// smoothing looks at; however long the stack. Cost: one pass, for each label of `each` as many as
// its labels fill memory. Thread rule: one user.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "io/point_metadata.h"
#include "tools/sampling/aligned_grid.h"
#include "tools/sampling/placement.h"
#include "tools/sampling/region_grid.h"
#include "tools/sampling/smoothed_mask.h"
#include "tools/sampling/voxel_selection.h"
#include "tools/slices/volume.h"

namespace stream_recon {

enum class PointKind {
  kCrossings,         ///< of grid edges and a value, linear interpolation
  kSmoothedBoundary,  ///< crossings of grid edges and the object's smoothed boundary
  kBoundaryVoxels,    ///< centres of the object's voxels with a face neighbour outside
};

struct SamplingOptions {
  PointKind kind = PointKind::kCrossings;
  double iso = 0;                           ///< kCrossings: finite, units of the voxels
  std::optional<VoxelSelection> selection;  ///< the object, for the other kinds
  /// In voxels (of those that are sampled); keep_thin is for kSmoothedBoundary. Boundary voxels are
  /// never smoothed.
  MaskSmoothing smoothing;
  RegionOfInterest region;
  GridSize every{1, 1, 1};           ///< samples every n-th voxel along i, j, k; >= 1
  std::vector<SliceOffset> offsets;  ///< one a slice of the volume; empty: none
  CoordinateSystem coordinates = CoordinateSystem::kWorld;
};

struct SampleCounts {
  std::uint64_t points = 0;
  std::uint64_t voxels = 0;         ///< of the object; 0 for kCrossings
  std::uint64_t voxels_lost = 0;    ///< of those, outside the smoothed boundary
  std::uint64_t voxels_gained = 0;  ///< other ones inside of it
};

/// What the points are, for people: "iso 100", "boundary voxels of label 13".
std::string description(const SamplingOptions& options);

using PointConsumer = std::function<void(const Point3&)>;

/// One walk after another over the same part of the same volume.
class Sampling {
 public:
  /// \throw std::invalid_argument region outside the volume
  Sampling(Volume& volume, const SamplingOptions& options);

  /// What is known of the points.
  PointMetadata metadata(const std::string& source) const;
  /// Hands out every point; may be called again, and then does the same.
  /// \throw InputError there is none; or what the volume throws
  SampleCounts run(const PointConsumer& consume);

  const Placement& placement() const { return placement_; }
  Grid& grid();

 private:
  SampleCounts run_mask(const PointConsumer& consume);
  [[noreturn]] void refuse_empty(const SampleCounts& counts);

  SamplingOptions options_;
  Placement placement_;
  RegionGrid region_;
  std::unique_ptr<AlignedGrid> aligned_;  ///< where there are offsets
};

}  // namespace stream_recon
