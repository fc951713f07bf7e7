// Boundary voxels of the folded solid: what a segmentation of serial slices leaves.
//
// Guarantees: points have integer coordinates, x and y in pixels, z in multiples of the slice step,
// in scan order (z, y, x); a voxel is one of them iff it is inside and one of its six neighbours in
// the stack is not. Every coordinate is exact in float32 up to 1e14 points.
// Memory: a few tables of one side's length. Thread rule: one user.
#pragma once

#include <cstdint>
#include <vector>

#include "spatial/point.h"

namespace stream_recon {

struct VoxelShellOptions {
  std::uint64_t points = 1000000;  ///< wanted; met within a few per cent
  std::uint32_t slice_step = 3;    ///< distance of neighbouring slices, pixels, at least 1
};

class VoxelShell {
 public:
  explicit VoxelShell(const VoxelShellOptions& options);

  /// The next boundary voxel; false at the end.
  bool next(Point3& out);

 private:
  friend std::uint64_t count_voxels(VoxelShell shell);
  struct Axis {
    std::vector<double> square, sine, cosine;
  };

  VoxelShell(std::int64_t radius, std::uint32_t slice_step);
  static Axis tabulate(std::int64_t count, std::int64_t step, double radius);
  static std::int64_t radius_for(const VoxelShellOptions& options);
  bool inside(std::size_t x, std::size_t y, std::size_t z) const;
  bool on_boundary() const;
  void advance();

  std::int64_t slice_step_;
  std::int64_t half_side_, half_depth_;
  Axis plane_, depth_;
  std::size_t x_ = 1, y_ = 1, z_ = 1;
};

/// The number of voxels a fresh shell delivers. Cost: one scan of the volume.
std::uint64_t count_voxels(VoxelShell shell);

}  // namespace stream_recon
