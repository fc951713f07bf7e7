#include "tools/sampling/placement.h"

#include <algorithm>
#include <cmath>

namespace stream_recon {

Placement::Placement(const VolumeGeometry& geometry, const PlacementOptions& options)
    : geometry_(geometry), options_(options) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    first_[axis] = static_cast<double>(options.region.low[axis]);
  }
  if (!options_.offsets.empty()) plan_shifts();
}

// A slice is moved by whole cells, all by the least that leaves none before the grid's edge; the
// rest of its offset goes into positions.
void Placement::plan_shifts() {
  const std::size_t slices =
      (options_.region.extent(2) + options_.every[2] - 1) / options_.every[2];
  const auto step_i = static_cast<double>(options_.every[0]);
  const auto step_j = static_cast<double>(options_.every[1]);
  std::vector<SliceOffset> whole;
  SliceOffset least{HUGE_VAL, HUGE_VAL};
  for (std::size_t k = 0; k < slices; ++k) {
    const SliceOffset& offset = options_.offsets.at(options_.region.low[2] + k * options_.every[2]);
    whole.push_back({std::round(offset.di / step_i), std::round(offset.dj / step_j)});
    rests_.push_back({offset.di - whole.back().di * step_i, offset.dj - whole.back().dj * step_j});
    least = {std::min(least.di, whole.back().di), std::min(least.dj, whole.back().dj)};
  }
  for (const SliceOffset& cells : whole) {
    shifts_.push_back({static_cast<std::size_t>(cells.di - least.di),
                       static_cast<std::size_t>(cells.dj - least.dj)});
  }
  first_[0] += least.di * step_i;
  first_[1] += least.dj * step_j;
}

SliceOffset Placement::rest(double k) const {
  if (rests_.empty()) return {};
  // Points of a padded mask may lie half a cell beyond the first or last slice.
  const double inside = std::clamp(k, 0.0, static_cast<double>(rests_.size() - 1));
  const auto below = static_cast<std::size_t>(inside);
  const SliceOffset& a = rests_[below];
  const SliceOffset& b = rests_[std::min(below + 1, rests_.size() - 1)];
  const double t = inside - static_cast<double>(below);
  return {a.di + t * (b.di - a.di), a.dj + t * (b.dj - a.dj)};
}

Point3 Placement::position(const GridPoint& place) const {
  const SliceOffset offset = rest(place.cell.z + place.fraction.z);
  // Whole numbers first: the sum's rounding must not depend on where the grid begins.
  const auto voxel = [&](std::size_t axis, double cell, double fraction) {
    const auto step = static_cast<double>(options_.every[axis]);
    return (first_[axis] + cell * step) + fraction * step;
  };
  const double i = voxel(0, place.cell.x, place.fraction.x) + offset.di;
  const double j = voxel(1, place.cell.y, place.fraction.y) + offset.dj;
  const double k = voxel(2, place.cell.z, place.fraction.z);
  if (options_.coordinates == CoordinateSystem::kIndex) return {i, j, k};
  return geometry_.position(i, j, k);
}

std::array<double, 3> Placement::spacing() const {
  std::array<double, 3> spacing{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const Point3& step = geometry_.step[axis];
    const bool world = options_.coordinates == CoordinateSystem::kWorld;
    spacing[axis] = static_cast<double>(options_.every[axis]) *
                    (world ? std::hypot(step.x, step.y, step.z) : 1);
  }
  return spacing;
}

}  // namespace stream_recon
