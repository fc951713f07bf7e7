// The gamma criterion: a Delaunay facet belongs to the surface where its two empty balls meet at
// an angle below a threshold, 90 degrees for the gamma-regular shape.
//
// For balls (x1, r1), (x2, r2):  cos delta = (|x1 - x2|^2 - r1^2 - r2^2) / (2 r1 r2); at the hull
// the outer ball is the half-space and cos delta = height / r1. Ties are not taken: at 90 degrees a
// facet is in iff |x1 - x2|^2 - r1^2 - r2^2 > 1e-9 (r1^2 + r2^2), at the hull iff height > 1e-9 r1;
// other thresholds keep the same margins. Thread rule: pure functions.
// Source: Attali, r-regular shape reconstruction from unorganized points, 1997.
#pragma once

#include <cmath>

#include "spatial/ball_estimate.h"
#include "spatial/facet_balls.h"

namespace stream_recon {

class GammaCriterion {
 public:
  /// \param delta_max_degrees angle in (0, 180]; facets strictly below it are taken
  explicit GammaCriterion(double delta_max_degrees);

  bool takes(const FacetBalls& balls) const;

  /// What takes() would say of the accurate balls, if the estimates are enough to know. One of the
  /// balls may be the half-space. A facet that is out at the hull is out beside any ball.
  Verdict judge(const BallEstimate& one, const BallEstimate& two) const {
    if (two.height == BallEstimate::kHalfSpace) return judge_at_hull(one.height);
    if (one.height == BallEstimate::kHalfSpace) return judge_at_hull(two.height);
    const double f = one.height;
    const double s = two.height;
    const double ff = 1 + f * f;
    const double ss = 1 + s * s;
    const double radii = std::sqrt(ff * ss);
    const double margin = kMargin / 2 * (ff + ss);
    const double value = f * s - 1 - cosine_ * radii - margin;
    return verdict(value, 5 * BallEstimate::kError * radii + margin / 1024);
  }

 private:
  static constexpr double kMargin = 1e-9;

  Verdict judge_at_hull(double f) const {
    if (f < hull_out_below_) return Verdict::kOut;
    return f > hull_in_above_ ? Verdict::kIn : Verdict::kUnsure;
  }

  /// NaN is unsure.
  static Verdict verdict(double value, double error) {
    if (value < -error) return Verdict::kOut;
    return value > error ? Verdict::kIn : Verdict::kUnsure;
  }

  double cosine_;
  double hull_out_below_;  ///< estimated heights for sure out or in at the hull
  double hull_in_above_;
};

/// Angle delta in degrees, in [0, 180]: 0 where the balls barely touch from outside.
double gamma_angle(const FacetBalls& balls);

}  // namespace stream_recon
