// The alpha criterion: a Delaunay facet belongs to the surface where some ball of radius alpha
// touches its three points and holds no point of the cloud inside.
//
// The centres of all empty balls of a facet are the segment between the centres of its two Delaunay
// balls (a ray at the hull), so their radii are the interval [mu_min, mu_max]: mu_min is the
// facet's own radius where the segment crosses its plane (a Gabriel facet), else the smaller ball's
// radius; mu_max is the larger ball's. The facet is taken iff mu_min <= alpha <= mu_max: the
// regular and the singular facets of the alpha shape. Radii within 1e-9 of alpha count as equal.
// Thread rule: pure functions. Source: Edelsbrunner, Muecke 1994, section 5.
#pragma once

#include "spatial/ball_estimate.h"
#include "spatial/facet_balls.h"

namespace stream_recon {

struct RadiusInterval {
  double smallest = 0;  ///< units of the input
  double largest = 0;   ///< infinite at the convex hull
};

RadiusInterval empty_ball_radii(const FacetBalls& balls);

/// \param alpha radius > 0, units of the input
bool is_alpha_facet(const FacetBalls& balls, double alpha);

class AlphaCriterion {
 public:
  /// \param alpha radius > 0, units of the input
  explicit AlphaCriterion(double alpha) : alpha_(alpha) {}

  bool takes(const FacetBalls& balls) const { return is_alpha_facet(balls, alpha_); }

  /// What takes() would say of the accurate balls, if the estimates are enough to know. One of the
  /// balls may be the half-space. A facet that is out at the hull is out beside any ball.
  Verdict judge(const BallEstimate& one, const BallEstimate& two) const;

 private:
  double alpha_;
};

}  // namespace stream_recon
