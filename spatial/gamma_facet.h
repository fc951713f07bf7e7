// The gamma criterion: a Delaunay facet belongs to the surface where its two empty balls meet at
// an angle below a threshold, 90 degrees for the gamma-regular shape.
//
// For balls (x1, r1), (x2, r2):  cos delta = (|x1 - x2|^2 - r1^2 - r2^2) / (2 r1 r2); at the hull
// the outer ball is the half-space and cos delta = height / r1. Ties are not taken: at 90 degrees a
// facet is in iff |x1 - x2|^2 - r1^2 - r2^2 > 1e-9 (r1^2 + r2^2), at the hull iff height > 1e-9 r1;
// other thresholds keep the same margins. Thread rule: pure functions.
// Source: Attali, r-regular shape reconstruction from unorganized points, 1997.
#pragma once

#include "spatial/facet_balls.h"

namespace stream_recon {

class GammaCriterion {
 public:
  /// \param delta_max_degrees angle in (0, 180]; facets strictly below it are taken
  explicit GammaCriterion(double delta_max_degrees);

  bool takes(const FacetBalls& balls) const;

 private:
  double cosine_;
};

/// Angle delta in degrees, in [0, 180]: 0 where the balls barely touch from outside.
double gamma_angle(const FacetBalls& balls);

}  // namespace stream_recon
