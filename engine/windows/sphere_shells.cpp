#include "engine/windows/sphere_shells.h"

#include <algorithm>

#include "spatial/vector.h"

namespace stream_recon {
namespace {

/// Thickness of a shell in units of the square of the points' extent: no smooth surface is as near
/// to a sphere, unless it is one.
constexpr double kThin = 0x1p-14;
/// A shared sphere saves a cut for each page; thicker shells make for larger half-spaces.
constexpr double kAsThin = 8;
constexpr std::size_t kSamples = 64;

double squared_extent(std::span<const Point3> points) {
  double largest = 0;
  for (const Point3& p : points) {
    const Point3 d = minus(p, points[0]);
    largest = std::max(largest, dot(d, d));
  }
  return largest;
}

double thickness(const FoundShell& shell) {
  return shell.heights.high - shell.heights.low;
}

bool is_thin(const FoundShell& shell, std::span<const Point3> points) {
  return thickness(shell) <= kThin * squared_extent(points);
}

std::optional<FoundShell> shell_on(const Sphere& sphere, std::span<const Point3> points) {
  const FoundShell shell{sphere, heights_over(sphere, points)};
  if (!is_thin(shell, points)) return std::nullopt;
  return shell;
}

std::vector<Point3> samples_of(std::span<const Point3> points) {
  const std::size_t step = std::max<std::size_t>(1, points.size() / kSamples);
  std::vector<Point3> samples;
  for (std::size_t i = 0; i < points.size(); i += step) samples.push_back(points[i]);
  return samples;
}

}  // namespace

std::optional<Sphere> shared_sphere(std::span<const Point3> samples) {
  const auto sphere = fit_sphere(samples);
  if (!sphere || !shell_on(*sphere, samples)) return std::nullopt;
  return sphere;
}

std::optional<FoundShell> find_shell(std::span<const Point3> points,
                                     const std::optional<Sphere>& shared) {
  const std::vector<Point3> samples = samples_of(points);
  const auto own = shared_sphere(samples);
  std::optional<FoundShell> shell;
  if (own) shell = shell_on(*own, points);
  if (!shared || !shell_on(*shared, samples)) return shell;
  const auto on_shared = shell_on(*shared, points);
  if (!on_shared) return shell;
  return !shell || thickness(*on_shared) <= kAsThin * thickness(*shell) ? on_shared : shell;
}

void append_shells(std::span<const std::optional<FoundShell>> pages, SphereShells& shells) {
  for (const auto& page : pages) {
    Shell& shell = shells.pages.emplace_back();
    if (!page) continue;
    if (shells.spheres.empty() || !(shells.spheres.back() == page->sphere)) {
      shells.spheres.push_back(page->sphere);
    }
    shell = {static_cast<std::uint32_t>(shells.spheres.size() - 1), page->heights.low};
  }
}

void close_shells(SphereShells& shells) {
  if (shells.spheres.size() != 1) return;
  Shell all = shells.pages.front();
  for (const Shell& page : shells.pages) {
    if (!page.exists()) return;
    all.low = std::min(all.low, page.low);
  }
  shells.cloud = all;
}

}  // namespace stream_recon
