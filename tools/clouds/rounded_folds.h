// Folds without creases: the side of a gyroid where its sum is negative, cut by the unit ball, the
// edge between the two rounded.
//
// The gyroid has 2.9 periods across the ball: in the whole ball no handle is thin. Rounding takes
// the larger of two distance-like values u and v, and where they differ by less than kRounding
// adds (kRounding - |u - v|)^2 / (4 kRounding); that has a continuous slope, whose length is at
// most the larger of theirs. Euler number -82, genus 42, and radii of curvature are about 0.05 or
// more. Volume and area are integrals that were found numerically, to the digits that are given.
// Thread rule: stateless.
#pragma once

#include "tools/clouds/known_solid.h"

namespace stream_recon {

class RoundedFolds final : public KnownSolid {
 public:
  double signed_bound(const Point3& p) const override;
  Point3 outward_normal(const Point3& p) const override;
  std::optional<Point3> try_surface_point(Random& random) const override;
  SolidTruth truth() const override { return {2.0681, 23.654, -82}; }
  double reach() const override { return 1; }
};

}  // namespace stream_recon
