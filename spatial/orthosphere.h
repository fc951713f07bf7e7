// The sphere orthogonal to four weighted points, and which tetrahedra it is in conflict with: what
// a walk through the Delaunay structure of the samples asks about the power diagram of their poles.
//
// A tetrahedron is in conflict with a weighted point (z, w) if the power of z to its circumsphere
// is below w. Guarantees: may_conflict() is true for every tetrahedron whose power is below w +
// error, whatever its own rounding, so for all in conflict with the exact sphere of the sites, as
// far as `error` bounds what rounding of sphere and sites does; it may be true for others, slivers
// above all. Thread rule: pure. Memory: none. Cost: about 20 ns a test. Source:
// docs/algorithms/weighted.md
#pragma once

#include <array>
#include <optional>

#include "spatial/point.h"

namespace stream_recon {

struct Orthosphere {
  Point3 centre;
  double weight = 0;  ///< power of the centre to each of the four
  /// By so much may the power of the centre to a ball, less the weight, be off where the ball's
  /// centre lies within the reach. Grows with the flatness of the four sites.
  double error = 0;
};

struct OrthosphereReach {
  double reach = 0;       ///< no ball that is asked about has its centre farther from a site
  double most_error = 0;  ///< spheres of larger ones are not given; units of the input, squared
  double rounding = 0;    ///< of a site's centre and radius, relative to both together
};

/// Nothing if the sites are so flat that the error is above most_error.
std::optional<Orthosphere> orthosphere(const std::array<WeightedPoint3, 4>& sites,
                                       const OrthosphereReach& reach);

/// The centre alone, however ill-conditioned; of four sites in one plane their mean. The same bits
/// for the same sites in the same order.
Point3 orthocentre(const std::array<WeightedPoint3, 4>& sites);

/// \param tetrahedron its corners, of either orientation
bool may_conflict(const std::array<Point3, 4>& tetrahedron, const Orthosphere& sphere);

}  // namespace stream_recon
