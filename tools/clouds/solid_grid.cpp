// Where the solid's bound says that the surface is far, a row is filled without further questions,
// so that no slice need be kept: three rows around a row are found anew for each of them.

#include "tools/clouds/solid_grid.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "spatial/vector.h"

namespace stream_recon {
namespace {

/// Halfway between an inside and an outside point until no number lies between: the outside one.
Point3 find_crossing(const KnownSolid& solid, Point3 inside, Point3 outside) {
  const auto half = [](double a, double b) { return a + (b - a) / 2; };
  for (;;) {
    const Point3 middle{half(outside.x, inside.x), half(outside.y, inside.y),
                        half(outside.z, inside.z)};
    if (middle == inside || middle == outside) return outside;
    (solid.contains(middle) ? inside : outside) = middle;
  }
}

double rounded_to_12_bits(double value) {
  int exponent = 0;
  const double fraction = std::frexp(value, &exponent);
  return std::ldexp(std::round(std::ldexp(fraction, 12)), exponent - 12);
}

}  // namespace

// One voxel more on every side than the solid reaches, so that all outermost ones are outside.
SolidGridScan::SolidGridScan(const KnownSolid& solid, const SolidGridOptions& options)
    : solid_(solid),
      options_(options),
      slice_distance_(options.pixel * options.slice_step),
      half_side_(static_cast<std::int64_t>(solid.reach() / options.pixel) + 2),
      half_depth_(static_cast<std::int64_t>(solid.reach() / slice_distance_) + 2) {
  enter_slice();
}

double SolidGridScan::place(std::size_t index, std::int64_t half, double step) const {
  return static_cast<double>(static_cast<std::int64_t>(index) - half) * step;
}

SolidGridScan::Row SolidGridScan::inside_row(std::size_t y, std::size_t z) const {
  Row row(static_cast<std::size_t>(2 * half_side_ + 1));
  Point3 p{0, place(y, half_side_, options_.pixel), place(z, half_depth_, slice_distance_)};
  for (std::size_t x = 0; x < row.size();) {
    p.x = place(x, half_side_, options_.pixel);
    const double bound = solid_.signed_bound(p);
    const double clear = std::floor(0.999 * std::abs(bound) / options_.pixel);
    const std::size_t end = std::min(row.size(), x + 1 + static_cast<std::size_t>(clear));
    std::fill(row.begin() + static_cast<std::ptrdiff_t>(x),
              row.begin() + static_cast<std::ptrdiff_t>(end), bound < 0);
    x = end;
  }
  return row;
}

void SolidGridScan::enter_slice() {
  y_ = 0;
  row_ = inside_row(0, z_);
  after_ = inside_row(1, z_);
}

void SolidGridScan::scan_row() {
  ++y_;
  before_ = std::exchange(row_, std::exchange(after_, inside_row(y_ + 1, z_)));
  above_ = inside_row(y_, z_ + 1);
  found_.clear();
  taken_ = 0;
  if (options_.samples != GridSamples::kCentres) return take_edges();
  below_ = inside_row(y_, z_ - 1);
  take_boundary_voxels();
}

void SolidGridScan::take_boundary_voxels() {
  const double y = place(y_, half_side_, options_.pixel);
  const double z = place(z_, half_depth_, slice_distance_);
  for (std::size_t x = 1; x + 1 < row_.size(); ++x) {
    const bool is_deep =
        row_[x - 1] && row_[x + 1] && before_[x] && after_[x] && below_[x] && above_[x];
    if (row_[x] && !is_deep) found_.push_back({place(x, half_side_, options_.pixel), y, z});
  }
}

// Each voxel has the edges to its next neighbours along x, y and z.
void SolidGridScan::take_edges() {
  const double pixel = options_.pixel;
  for (std::size_t x = 1; x + 1 < row_.size(); ++x) {
    const Point3 voxel{place(x, half_side_, pixel), place(y_, half_side_, pixel),
                       place(z_, half_depth_, slice_distance_)};
    const bool inside = row_[x] != 0;
    if (inside != (row_[x + 1] != 0)) take_edge(voxel, {voxel.x + pixel, voxel.y, voxel.z}, inside);
    if (inside != (after_[x] != 0)) take_edge(voxel, {voxel.x, voxel.y + pixel, voxel.z}, inside);
    if (inside != (above_[x] != 0))
      take_edge(voxel, {voxel.x, voxel.y, voxel.z + slice_distance_}, inside);
  }
}

void SolidGridScan::take_edge(const Point3& a, const Point3& b, bool a_inside) {
  if (options_.samples == GridSamples::kFaces) {
    found_.push_back(scaled(plus(a, b), 0.5));
  } else {
    found_.push_back(a_inside ? find_crossing(solid_, a, b) : find_crossing(solid_, b, a));
  }
}

bool SolidGridScan::next(Point3& out) {
  while (taken_ == found_.size()) {
    if (y_ + 2 >= static_cast<std::size_t>(2 * half_side_)) {
      if (z_ + 2 >= static_cast<std::size_t>(2 * half_depth_)) return false;
      ++z_;
      enter_slice();
    }
    scan_row();
  }
  out = found_[taken_++];
  return true;
}

std::uint64_t count_samples(const KnownSolid& solid, const SolidGridOptions& options) {
  SolidGridOptions countable = options;
  // A crossing takes fifty questions more than the face that it goes through.
  if (options.samples == GridSamples::kCrossings) countable.samples = GridSamples::kFaces;
  SolidGridScan scan(solid, countable);
  std::uint64_t count = 0;
  for (Point3 p; scan.next(p);) ++count;
  return count;
}

// Samples grow with the square of the finest detail: count few of them, then scale. Without a
// count, a surface of all directions alike has area / 2 faces of unit size across each axis.
double pixel_for(const KnownSolid& solid, const SolidGridOptions& options, std::uint64_t points) {
  constexpr double kMostCounted = 100000;
  const double wanted = std::max(1.0, static_cast<double>(points));
  const double faces = solid.truth().area / 2 * (1 + 2.0 / options.slice_step);
  const double coarsest = solid.reach() / 2;
  SolidGridOptions trial = options;
  double pixel = std::sqrt(faces / wanted);
  for (int round = 0; round < 2; ++round) {
    trial.pixel = std::clamp(pixel, std::sqrt(faces / kMostCounted), coarsest);
    const std::uint64_t counted = std::max<std::uint64_t>(1, count_samples(solid, trial));
    pixel = trial.pixel * std::sqrt(static_cast<double>(counted) / wanted);
    if (wanted > kMostCounted) break;
  }
  return rounded_to_12_bits(std::min(pixel, coarsest));
}

}  // namespace stream_recon
