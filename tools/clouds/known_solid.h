// Solids whose truth is known: what is inside, the surface, its normals, area, volume and topology.
//
// Every solid lies around the origin in the box reach() and is about one unit large.
// Guarantees: results are the same bits on every machine. Thread rule: const, any number of
// readers; one user a generator. Cost: up to 100 ns a call.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "spatial/point.h"
#include "tools/clouds/random.h"

namespace stream_recon {

struct SolidTruth {
  double volume;
  double area;         ///< of the whole surface, cavities included
  std::int64_t euler;  ///< of the whole surface
};

class KnownSolid {
 public:
  virtual ~KnownSolid() = default;

  /// Negative inside, not elsewhere; its magnitude is at most the distance to the surface.
  virtual double signed_bound(const Point3& p) const = 0;
  bool contains(const Point3& p) const { return signed_bound(p) < 0; }

  /// Away from the inside, of length 1. \pre p is on the surface, or nearly so
  virtual Point3 outward_normal(const Point3& p) const = 0;

  /// A point on the surface: each call tries one candidate. The same density everywhere, but for
  /// the solid that is there to be uneven.
  virtual std::optional<Point3> try_surface_point(Random& random) const = 0;

  virtual SolidTruth truth() const = 0;

  /// No point of the solid has a larger coordinate, nor a smaller negative one.
  virtual double reach() const = 0;
};

struct SolidOptions {
  std::string name;  ///< one of solid_names()
  double width = 0;  ///< pair: of the gap, above 0; plate: its thickness, above 0 and below 1;
                     ///< 0: 0.05
};

std::span<const std::string_view> solid_names();

/// \throw std::invalid_argument unknown name, width out of range
std::unique_ptr<const KnownSolid> make_solid(const SolidOptions& options);

}  // namespace stream_recon
