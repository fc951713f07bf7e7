#include "tools/sampling/boundary_voxel_scan.h"

namespace stream_recon {

// The outermost cells are outside, so every cell of the object has six neighbours.
bool BoundaryVoxelScan::step() {
  const auto [width, height, depth] = mask_.size();
  if (k_ == depth) return false;
  const std::size_t k = k_++;
  if (k == 0 || k + 1 == depth) return true;
  const auto below = mask_.slice(k - 1);
  const auto here = mask_.slice(k);
  const auto above = mask_.slice(k + 1);
  for (std::size_t j = 1; j + 1 < height; ++j) {
    for (std::size_t i = 1; i + 1 < width; ++i) {
      const std::size_t at = j * width + i;
      if (here[at] == 0) continue;
      const int neighbors =
          here[at - 1] + here[at + 1] + here[at - width] + here[at + width] + below[at] + above[at];
      if (neighbors == 6) continue;
      consume_({{static_cast<double>(i), static_cast<double>(j), static_cast<double>(k)}, {}});
      ++points_;
    }
  }
  return true;
}

}  // namespace stream_recon
