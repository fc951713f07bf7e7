// Which pages of the index hold points of one sphere, nearly: there the search asks about balls by
// their half-spaces (spatial/sphere_cut.h).
//
// Guarantees: no point of a page, or of the cloud, is lower over the sphere of its shell than
// `low`. Thread rule: offer() one page a thread, the rest one writer; const and shared once built.
// Memory: 12 bytes for 1000 points. Cost: 3 us a page that is on no sphere, else 30 ns a point for
// each sphere tried.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "spatial/sphere_fit.h"

namespace stream_recon {

struct Shell {
  static constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

  std::uint32_t sphere = kNone;  ///< its place in SphereShells::spheres
  double low = 0;                ///< height

  bool exists() const { return sphere != kNone; }
};

struct SphereShells {
  /// At most, bytes for each page.
  static constexpr std::uint64_t kBytesAPage = sizeof(Shell) + sizeof(Sphere);

  std::vector<Sphere> spheres;
  std::vector<Shell> pages;
  Shell cloud;  ///< of all points
};

/// A shell with its sphere, while it is not known which pages share one.
struct FoundShell {
  Sphere sphere;
  Heights heights;
};

/// The shell of the points: on `shared` where that is about as thin as the best of their own, or
/// on this one; nothing where they are on no sphere.
std::optional<FoundShell> find_shell(std::span<const Point3> points,
                                     const std::optional<Sphere>& shared);

/// The sphere of a few points of a larger part of the cloud, if they are on one.
std::optional<Sphere> shared_sphere(std::span<const Point3> samples);

/// Adds the shells of the next pages.
void append_shells(std::span<const std::optional<FoundShell>> pages, SphereShells& shells);

/// Finds out whether one sphere is that of all pages.
void close_shells(SphereShells& shells);

}  // namespace stream_recon
