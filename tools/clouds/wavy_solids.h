// Solids with waves: the blob and the folded one. Areas, and the blob's volume, are integrals that
// were found numerically, to the digits that are given.
//
// Thread rule: stateless.
#pragma once

#include "tools/clouds/known_solid.h"

namespace stream_recon {

/// A ball of radius 1 with smooth bumps of up to 0.2.
class BlobSolid final : public KnownSolid {
 public:
  double signed_bound(const Point3& p) const override;
  Point3 outward_normal(const Point3& p) const override;
  std::optional<Point3> try_surface_point(Random& random) const override;
  SolidTruth truth() const override;
  double reach() const override { return 1.2; }
};

/// One side of a gyroid, cut by a ball (folded_solid.h).
///
/// The surface of a ball of radius r has Euler number 1 + the sum over the gyroid's points that are
/// nearest to or farthest from the origin among their neighbours (+1) or neither (-1) within r. In
/// the unit ball it is -106, but six of those points lie 7e-7 outside and 18 less than 0.013
/// inside: handles that thin are hard to sample. In the ball of kSpongeRadius it is -82, genus 42,
/// and the next of those points are 0.01 away.
class FoldedSolid final : public KnownSolid {
 public:
  static constexpr double kSpongeRadius = 0.9407;

  /// \param radius 1 or kSpongeRadius
  explicit FoldedSolid(double radius) : radius_(radius) {}

  double signed_bound(const Point3& p) const override;
  Point3 outward_normal(const Point3& p) const override;
  std::optional<Point3> try_surface_point(Random& random) const override;
  SolidTruth truth() const override;
  double reach() const override { return radius_; }

 private:
  double radius_;
};

}  // namespace stream_recon
