#include "tools/clouds/solid_samples.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "spatial/vector.h"
#include "tools/clouds/solid_grid.h"

namespace stream_recon {
namespace {

/// Nearly normal with deviation 1, the same bits on every machine: a sum of 12 uniform numbers.
double normal_number(Random& random) {
  double sum = -6;
  for (int i = 0; i < 12; ++i) sum += random.unit();
  return sum;
}

class SurfaceSamples final : public PointSource {
 public:
  explicit SurfaceSamples(const SolidSampleOptions& options)
      : solid_(make_solid(options.solid)), random_(options.seed), count_(options.points) {
    if (options.sampling == SolidSampling::kNoisy)
      deviation_ = options.noise * std::sqrt(solid_->truth().area / static_cast<double>(count_));
  }

  std::size_t read(std::span<Point3> out) override {
    const std::size_t n = std::min<std::uint64_t>(out.size(), count_ - delivered_);
    for (Point3& p : out.first(n)) p = sample();
    delivered_ += n;
    return n;
  }
  std::optional<std::uint64_t> announced_count() const override { return count_; }
  std::uint64_t bytes_read() const override { return 0; }

 private:
  Point3 sample() {
    for (;;) {
      const std::optional<Point3> p = solid_->try_surface_point(random_);
      if (!p) continue;
      if (deviation_ == 0) return *p;
      const double moved = deviation_ * normal_number(random_);
      return plus(*p, scaled(solid_->outward_normal(*p), moved));
    }
  }

  std::unique_ptr<const KnownSolid> solid_;
  Random random_;
  std::uint64_t count_;
  std::uint64_t delivered_ = 0;
  double deviation_ = 0;
};

GridSamples grid_samples(SolidSampling sampling) {
  if (sampling == SolidSampling::kCrossings) return GridSamples::kCrossings;
  return sampling == SolidSampling::kFaces ? GridSamples::kFaces : GridSamples::kCentres;
}

class VoxelSamples final : public PointSource {
 public:
  explicit VoxelSamples(const SolidSampleOptions& options)
      : solid_(make_solid(options.solid)),
        grid_(grid_for(*solid_, options)),
        scan_(*solid_, grid_),
        count_(count_samples(*solid_, grid_)) {
    metadata_.spacing = {grid_.pixel, grid_.pixel, grid_.pixel * grid_.slice_step};
    metadata_.source = options.solid.name;
    metadata_.value = kSolidSamplingNames.at(static_cast<std::size_t>(options.sampling));
  }

  std::size_t read(std::span<Point3> out) override {
    std::size_t n = 0;
    while (n < out.size() && scan_.next(out[n])) ++n;
    return n;
  }
  std::optional<std::uint64_t> announced_count() const override { return count_; }
  const PointMetadata& metadata() const override { return metadata_; }
  std::uint64_t bytes_read() const override { return 0; }

 private:
  static SolidGridOptions grid_for(const KnownSolid& solid, const SolidSampleOptions& options) {
    SolidGridOptions grid{.samples = grid_samples(options.sampling),
                          .slice_step = options.slice_step};
    grid.pixel = pixel_for(solid, grid, options.points);
    return grid;
  }

  std::unique_ptr<const KnownSolid> solid_;
  SolidGridOptions grid_;
  SolidGridScan scan_;
  std::uint64_t count_;
  PointMetadata metadata_;
};

}  // namespace

std::unique_ptr<PointSource> sample_solid(const SolidSampleOptions& options) {
  if (options.slice_step < 1 || options.slice_step > 1000)
    throw std::invalid_argument("the slice step must be 1 to 1000 pixels");
  if (!(options.noise >= 0 && options.noise <= 10))
    throw std::invalid_argument("the noise must be 0 to 10 spacings");
  if (options.sampling == SolidSampling::kRandom || options.sampling == SolidSampling::kNoisy)
    return std::make_unique<SurfaceSamples>(options);
  return std::make_unique<VoxelSamples>(options);
}

}  // namespace stream_recon
