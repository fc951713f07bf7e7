// A volume of scalar voxels, read slice by slice.
//
// A voxel (i, j, k) lies at origin + i * step[0] + j * step[1] + k * step[2], in the file's
// physical units (millimetres for medical formats): ITK's physical space.
// Slices may be read in any order and again; rising k, and 0 after the last, are cheap.
// Thread rule: one reader.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <string>

#include "spatial/point.h"

namespace stream_recon {

struct VolumeGeometry {
  std::array<std::size_t, 3> size{};  ///< voxels along i, j, k
  Point3 origin;                      ///< centre of voxel (0, 0, 0)
  std::array<Point3, 3> step{};       ///< from a voxel to the next along i, j, k
  bool has_spacing = true;            ///< else the length of `step` is 1 for want of a better one

  Point3 position(double i, double j, double k) const {
    return {origin.x + (i * step[0].x + j * step[1].x + k * step[2].x),
            origin.y + (i * step[0].y + j * step[1].y + k * step[2].y),
            origin.z + (i * step[0].z + j * step[1].z + k * step[2].z)};
  }
};

class Volume {
 public:
  virtual ~Volume() = default;

  virtual const VolumeGeometry& geometry() const = 0;

  /// What the voxels are and where they come from, for a log line: "NIfTI volume brain.nii.gz".
  virtual std::string source() const { return "volume"; }

  /// Fills `out` (size[0] * size[1] values, i fastest) with slice k.
  /// \throw InputError truncated or damaged file
  virtual void read_slice(std::size_t k, std::span<double> out) = 0;
};

}  // namespace stream_recon
