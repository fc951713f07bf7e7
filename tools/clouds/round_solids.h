// Solids bounded by spheres, tori and planes: distances, areas and volumes are exact.
//
// Thread rule: const, any number of readers.
#pragma once

#include <vector>

#include "tools/clouds/known_solid.h"

namespace stream_recon {

/// Bounded by spheres that do not meet.
class SphereSolid final : public KnownSolid {
 public:
  struct Sphere {
    Point3 center;
    double radius;
    bool is_cavity;  ///< the solid is outside of it
  };

  explicit SphereSolid(std::vector<Sphere> spheres) : spheres_(std::move(spheres)) {}

  double signed_bound(const Point3& p) const override;
  Point3 outward_normal(const Point3& p) const override;
  std::optional<Point3> try_surface_point(Random& random) const override;
  SolidTruth truth() const override;
  double reach() const override;

 private:
  struct Nearest {
    const Sphere& sphere;
    double distance;  ///< negative inside the solid
  };
  Nearest nearest(const Point3& p) const;

  std::vector<Sphere> spheres_;
};

/// The torus with radii 1 and 0.4 around the z axis.
class TorusSolid final : public KnownSolid {
 public:
  /// `is_even`: else the samples' distance grows smoothly with x, from 1 to 4 times the least.
  explicit TorusSolid(bool is_even) : is_even_(is_even) {}

  double signed_bound(const Point3& p) const override;
  Point3 outward_normal(const Point3& p) const override;
  std::optional<Point3> try_surface_point(Random& random) const override;
  SolidTruth truth() const override;
  double reach() const override;

 private:
  bool is_even_;
};

/// A round plate of diameter 2 with a rounded rim, oblique to the axes: all points within
/// thickness / 2 of a disc.
class PlateSolid final : public KnownSolid {
 public:
  explicit PlateSolid(double thickness) : half_(thickness / 2), disc_(1 - half_) {}

  double signed_bound(const Point3& p) const override;
  Point3 outward_normal(const Point3& p) const override;
  std::optional<Point3> try_surface_point(Random& random) const override;
  SolidTruth truth() const override;
  double reach() const override { return 1; }

 private:
  double half_;  ///< of the thickness
  double disc_;  ///< radius of the flat part
};

}  // namespace stream_recon
