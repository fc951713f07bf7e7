#include "tools/clouds/cloud.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <stdexcept>

#include "tools/clouds/grids_and_curves.h"
#include "tools/clouds/random.h"
#include "tools/clouds/smooth_surfaces.h"
#include "tools/clouds/voxel_shell.h"

namespace stream_recon {
namespace {

constexpr std::array<CloudKind, 19> kKinds{{
    {"cube", "random in the unit cube"},
    {"sphere", "random on the unit sphere"},
    {"ellipsoid", "random on a smooth ellipsoid"},
    {"blob", "random on a smooth bumpy ball"},
    {"torus", "random on a torus"},
    {"folded", "random on a gyroid cut by a ball, of large genus"},
    {"sponge", "folded in a smaller ball, of genus 42: no handle is very thin"},
    {"folds", "random on a gyroid cut by a ball, edges rounded, of genus 42"},
    {"nested", "random on a shell with a ball in its cavity"},
    {"pair", "random on two balls --width apart"},
    {"plate", "random on a round oblique plate, --width thick, with a rounded rim"},
    {"uneven", "random on a torus, samples 4 times as far apart on one side"},
    {"lattice", "a full block of grid points, the last layer as far as N goes"},
    {"shell", "boundary voxels of the folded solid, about N, slices --slice-step apart"},
    {"line", "random on a line, exactly collinear"},
    {"plane", "random in a plane, exactly coplanar"},
    {"circle", "on a circle, nearly cocircular"},
    {"helix", "on a helix, evenly spaced"},
    {"skew", "on two skew lines: tetrahedra grow with the square of N"},
}};

/// `point` makes the point of an index.
class Counted : public PointSource {
 public:
  using Maker = std::function<Point3(std::uint64_t)>;
  Counted(std::uint64_t count, Maker maker) : count_(count), maker_(std::move(maker)) {}

  std::size_t read(std::span<Point3> out) override {
    const std::size_t n = std::min<std::uint64_t>(out.size(), count_ - next_);
    for (std::size_t i = 0; i < n; ++i) out[i] = maker_(next_ + i);
    next_ += n;
    return n;
  }
  std::optional<std::uint64_t> announced_count() const override { return count_; }
  std::uint64_t bytes_read() const override { return 0; }

 private:
  std::uint64_t count_;
  std::uint64_t next_ = 0;
  Maker maker_;
};

class ShellSource : public PointSource {
 public:
  explicit ShellSource(const VoxelShell& shell) : shell_(shell), count_(count_voxels(shell)) {}

  std::size_t read(std::span<Point3> out) override {
    std::size_t n = 0;
    while (n < out.size() && shell_.next(out[n])) ++n;
    return n;
  }
  std::optional<std::uint64_t> announced_count() const override { return count_; }
  std::uint64_t bytes_read() const override { return 0; }

 private:
  VoxelShell shell_;
  std::uint64_t count_;
};

/// Repeats a sampler that tries one candidate a call.
Counted::Maker repeat(std::uint64_t seed, std::optional<Point3> (*attempt)(Random&)) {
  return [random = Random(seed), attempt](std::uint64_t) mutable {
    for (;;) {
      if (const std::optional<Point3> p = attempt(random)) return *p;
    }
  };
}

Counted::Maker random_maker(const CloudOptions& options) {
  const std::uint64_t seed = options.seed;
  if (options.kind == "ellipsoid") return repeat(seed, try_ellipsoid_point);
  Random random(seed);
  if (options.kind == "cube") return [random](std::uint64_t) mutable { return random.in_cube(); };
  if (options.kind == "line")
    return [random](std::uint64_t) mutable { return collinear_point(random); };
  if (options.kind == "plane")
    return [random](std::uint64_t) mutable { return coplanar_point(random); };
  return nullptr;
}

Counted::Maker indexed_maker(const CloudOptions& options) {
  const std::uint64_t count = options.points;
  if (options.kind == "lattice")
    return [grid = GridBlock(count)](std::uint64_t i) { return grid.point(i); };
  if (options.kind == "circle") return [count](std::uint64_t i) { return circle_point(i, count); };
  if (options.kind == "helix") return [count](std::uint64_t i) { return helix_point(i, count); };
  if (options.kind == "skew")
    return [count](std::uint64_t i) { return skew_lines_point(i, count); };
  return nullptr;
}

bool is_solid(const std::string& kind) {
  const auto names = solid_names();
  return std::find(names.begin(), names.end(), kind) != names.end();
}

}  // namespace

std::span<const CloudKind> cloud_kinds() {
  return kKinds;
}

std::unique_ptr<PointSource> make_cloud(const CloudOptions& options) {
  if (options.kind == "shell") {
    if (options.slice_step < 1 || options.slice_step > 1000)
      throw std::invalid_argument("the slice step must be 1 to 1000 pixels");
    return std::make_unique<ShellSource>(
        VoxelShell(VoxelShellOptions{options.points, options.slice_step}));
  }
  if (is_solid(options.kind)) {
    return sample_solid({{options.kind, options.width},
                         options.sampling,
                         options.points,
                         options.seed,
                         options.slice_step,
                         options.noise});
  }
  if (options.sampling != SolidSampling::kRandom)
    throw std::invalid_argument("this kind of cloud has but one sampling: " + options.kind);
  Counted::Maker maker = random_maker(options);
  if (!maker) maker = indexed_maker(options);
  if (!maker) throw std::invalid_argument("unknown kind of cloud: " + options.kind);
  return std::make_unique<Counted>(options.points, std::move(maker));
}

}  // namespace stream_recon
