// The gyroid is a sum of products of one-dimensional waves, so tables of sines and cosines along
// the axes make a voxel as cheap as three products, and no slice need be kept.

#include "tools/clouds/voxel_shell.h"

#include <algorithm>
#include <cmath>

#include "tools/clouds/folded_solid.h"
#include "tools/clouds/trigonometry.h"

namespace stream_recon {

VoxelShell::VoxelShell(const VoxelShellOptions& options)
    : VoxelShell(radius_for(options), options.slice_step) {}

VoxelShell::VoxelShell(std::int64_t radius, std::uint32_t slice_step)
    : slice_step_(slice_step),
      half_side_(radius + 1),
      half_depth_(radius / slice_step_ + 1),
      plane_(tabulate(half_side_, 1, static_cast<double>(radius))),
      depth_(tabulate(half_depth_, slice_step_, static_cast<double>(radius))) {}

// Boundary voxels grow with the square of the radius: count a small shell, then scale it.
std::int64_t VoxelShell::radius_for(const VoxelShellOptions& options) {
  const auto wanted = static_cast<double>(options.points);
  double radius = 12.0 * options.slice_step;
  for (int round = 0; round < 2; ++round) {
    const auto trial = static_cast<std::int64_t>(std::max(radius, 2.0));
    const auto counted = static_cast<double>(
        std::max<std::uint64_t>(1, count_voxels(VoxelShell(trial, options.slice_step))));
    radius = static_cast<double>(trial) * std::sqrt(wanted / counted);
    if (radius > 400) break;
  }
  return static_cast<std::int64_t>(std::max(radius + 0.5, 2.0));
}

VoxelShell::Axis VoxelShell::tabulate(std::int64_t half, std::int64_t step, double radius) {
  Axis axis;
  for (std::int64_t i = -half; i <= half; ++i) {
    const double position = static_cast<double>(i * step) / radius;
    const SineCosine wave = sine_cosine(kGyroidWave * position);
    axis.square.push_back(position * position);
    axis.sine.push_back(wave.sine);
    axis.cosine.push_back(wave.cosine);
  }
  return axis;
}

bool VoxelShell::inside(std::size_t x, std::size_t y, std::size_t z) const {
  if (plane_.square[x] + plane_.square[y] + depth_.square[z] > 1) return false;
  return gyroid_value({plane_.sine[x], plane_.sine[y], depth_.sine[z]},
                      {plane_.cosine[x], plane_.cosine[y], depth_.cosine[z]}) < 0;
}

bool VoxelShell::on_boundary() const {
  return inside(x_, y_, z_) &&
         !(inside(x_ - 1, y_, z_) && inside(x_ + 1, y_, z_) && inside(x_, y_ - 1, z_) &&
           inside(x_, y_ + 1, z_) && inside(x_, y_, z_ - 1) && inside(x_, y_, z_ + 1));
}

// The outermost voxels of the tables lie outside the ball, so the scan leaves them out.
void VoxelShell::advance() {
  const std::size_t side = plane_.square.size() - 1;
  if (++x_ < side) return;
  x_ = 1;
  if (++y_ < side) return;
  y_ = 1;
  ++z_;
}

bool VoxelShell::next(Point3& out) {
  while (z_ + 1 < depth_.square.size()) {
    const bool found = on_boundary();
    if (found) {
      out = {static_cast<double>(static_cast<std::int64_t>(x_) - half_side_),
             static_cast<double>(static_cast<std::int64_t>(y_) - half_side_),
             static_cast<double>((static_cast<std::int64_t>(z_) - half_depth_) * slice_step_)};
    }
    advance();
    if (found) return true;
  }
  return false;
}

std::uint64_t count_voxels(VoxelShell shell) {
  std::uint64_t count = 0;
  for (Point3 p; shell.next(p);) ++count;
  return count;
}

}  // namespace stream_recon
