// Samples of a solid on a grid of voxels, as a segmentation of a stack of slices leaves them.
//
// The grid has its voxels at whole multiples of the pixel along x and y, and of slice_step pixels
// along z; a voxel is inside if its centre is.
// Guarantees: points come in scan order of their voxels (z, y, x), a function of the solid and the
// options alone; the pixel has 12 significant bits, so that every coordinate of a voxel is exact,
// in float32 too up to 4096 voxels from the origin. Memory: five rows of voxels. Thread rule: one
// user. Cost: about 10 calls of the solid for each crossing of a row with its surface, three times.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "tools/clouds/known_solid.h"

namespace stream_recon {

enum class GridSamples {
  kCrossings,  ///< of the surface and grid edges whose ends differ, in double precision
  kFaces,      ///< centres of the faces between an inside and an outside voxel
  kCentres,    ///< inside voxels with an outside one among their six neighbours
};

struct SolidGridOptions {
  GridSamples samples = GridSamples::kCrossings;
  double pixel = 0.01;           ///< units of the solid, above 0
  std::uint32_t slice_step = 1;  ///< distance of slices in pixels, at least 1
};

class SolidGridScan {
 public:
  /// The solid outlives the scan.
  SolidGridScan(const KnownSolid& solid, const SolidGridOptions& options);

  /// The next sample; false at the end.
  bool next(Point3& out);

 private:
  using Row = std::vector<char>;  ///< by x: whether inside

  double place(std::size_t index, std::int64_t half, double step) const;
  Row inside_row(std::size_t y, std::size_t z) const;
  void enter_slice();
  void scan_row();
  void take_boundary_voxels();
  void take_edges();
  void take_edge(const Point3& a, const Point3& b, bool a_inside);

  const KnownSolid& solid_;
  SolidGridOptions options_;
  double slice_distance_;
  std::int64_t half_side_, half_depth_;
  std::size_t y_ = 0, z_ = 1;
  Row before_, row_, after_, below_, above_;
  std::vector<Point3> found_;  ///< of the current row
  std::size_t taken_ = 0;
};

/// The number of samples. Cost: a whole scan.
std::uint64_t count_samples(const KnownSolid& solid, const SolidGridOptions& options);

/// The pixel that gives about `points` samples, within a few per cent.
/// \param options whose pixel is not looked at
double pixel_for(const KnownSolid& solid, const SolidGridOptions& options, std::uint64_t points);

}  // namespace stream_recon
