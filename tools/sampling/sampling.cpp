#include "tools/sampling/sampling.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "io/error.h"
#include "tools/sampling/blurred_grid.h"
#include "tools/sampling/iso_scan.h"
#include "tools/sampling/label_table.h"
#include "tools/sampling/object_scan.h"

namespace stream_recon {
namespace {

PlacementOptions placement_options(const SamplingOptions& options, const GridBox& box) {
  return {box, options.every, options.offsets, options.coordinates};
}

GridBox whole_box(const Grid& grid) {
  return {{0, 0, 0}, grid.size()};
}

/// "0 to 255": the finite values of a grid.
std::string value_range(Grid& grid) {
  double low = HUGE_VAL;
  double high = -HUGE_VAL;
  std::vector<double> slice(grid.slice_cells());
  for (std::size_t k = 0; k < grid.size()[2]; ++k) {
    grid.read_slice(k, slice);
    for (const double value : slice) {
      if (!std::isfinite(value)) continue;
      low = std::min(low, value);
      high = std::max(high, value);
    }
  }
  return low > high ? "no number" : fmt::format("{} to {}", low, high);
}

}  // namespace

std::string description(const SamplingOptions& options) {
  switch (options.kind) {
    case PointKind::kCrossings:
      return fmt::format("iso {}", options.iso);
    case PointKind::kSmoothedBoundary:
      return "boundary of " + options.selection.value().description();
    case PointKind::kBoundaryVoxels:
      break;
  }
  return "boundary voxels of " + options.selection.value().description();
}

Sampling::Sampling(Volume& volume, const SamplingOptions& options)
    : options_(options),
      placement_(volume.geometry(),
                 placement_options(options, box_of(options.region, volume.geometry().size))),
      region_(volume, box_of(options.region, volume.geometry().size), options.every) {
  if (!placement_.shifts().empty()) {
    aligned_ = std::make_unique<AlignedGrid>(region_, placement_.shifts());
  }
}

Grid& Sampling::grid() {
  if (aligned_) return *aligned_;
  return region_;
}

PointMetadata Sampling::metadata(const std::string& source) const {
  return {placement_.spacing(), source, description(options_)};
}

SampleCounts Sampling::run(const PointConsumer& consume) {
  SampleCounts counts;
  if (options_.kind == PointKind::kCrossings) {
    std::unique_ptr<Grid> blurred;
    if (options_.smoothing.sigma > 0) {
      blurred =
          std::make_unique<BlurredGrid>(grid(), options_.smoothing.sigma, BeyondEdge::kIgnored);
    }
    IsoScan scan(blurred ? *blurred : grid(), options_.iso,
                 [&](const GridPoint& p) { consume(placement_.position(p)); });
    counts.points = scan.run();
  } else {
    counts = run_mask(consume);
  }
  if (counts.points == 0) refuse_empty(counts);
  return counts;
}

SampleCounts Sampling::run_mask(const PointConsumer& consume) {
  RecentSlices slices(grid(), 1);
  ObjectScan scan(slices, options_.selection.value(),
                  {options_.kind, options_.smoothing, whole_box(grid())},
                  [&](const GridPoint& p) { consume(placement_.position(p)); });
  while (scan.step()) {
  }
  return scan.counts();
}

void Sampling::refuse_empty(const SampleCounts& counts) {
  if (counts.voxels > 0) {
    throw InputError(fmt::format(
        "all {} voxels of the object ({}) are smoothed away; add --keep-thin, or smooth less",
        counts.voxels, options_.selection->description()));
  }
  if (options_.selection && options_.selection->is_of_labels()) {
    throw InputError(fmt::format("no voxel has {}; labels here: {}",
                                 options_.selection->description(),
                                 label_list(find_labels(grid()))));
  }
  throw InputError(fmt::format("no point: nothing is the {} here; the voxels hold {}",
                               description(options_), value_range(grid())));
}

}  // namespace stream_recon
