// Balls of Delaunay facets known roughly but surely, and what a criterion makes of them.
//
// Most facets are far from every threshold. A criterion judges them on estimates, which cost little
// because the four facets of a tetrahedron share them (spatial/cell_balls.h); only what stays
// unsure, and what is taken and needs its angle, is asked of the accurate balls
// (spatial/facet_balls.h). A criterion is sure only of what the accurate balls would decide too.
// Thread rule: values.
#pragma once

#include <limits>

namespace stream_recon {

/// A ball seen from one of its facets.
struct BallEstimate {
  /// How far an estimate h may be from the height H, both over the facet's radius, in units of the
  /// ball's radius over the facet's radius: |h - H| <= kError sqrt(1 + H^2). An estimate of the
  /// ball's radius has at most this relative error. NaN where that cannot be promised.
  static constexpr double kError = 0x1p-16;

  static constexpr double kHalfSpace = std::numeric_limits<double>::infinity();

  double height = kHalfSpace;  ///< over the facet's radius, positive on the side of the apex
  double radius = kHalfSpace;  ///< units of the input
};

enum class Verdict {
  kOut,
  kIn,
  kUnsure,
};

}  // namespace stream_recon
