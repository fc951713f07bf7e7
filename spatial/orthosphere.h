// The sphere orthogonal to four weighted points, and which tetrahedra it is in conflict with: what a
// walk through the Delaunay structure of the samples asks about the power diagram of their poles.
//
// A tetrahedron is in conflict with a weighted point (z, w) if the power of z to its circumsphere is
// below w. Guarantees: may_conflict() is true for all that are, whatever the rounding, given that
// centre and weight are within `error` of the truth as orthosphere() says; it may be true for
// others, slivers above all. Thread rule: pure. Cost: about 20 ns.
// Source: docs/algorithms/weighted.md
#pragma once

#include <array>
#include <optional>

#include "spatial/point.h"

namespace stream_recon {

struct Orthosphere {
  Point3 centre;
  double weight = 0;  ///< power of the centre to each of the four
  /// The power of the centre to a ball whose centre lies within `reach` is known up to this.
  double error = 0;
};

struct OrthosphereReach {
  double reach = 0;      ///< no ball that is asked about has its centre farther from the origin
  double most_error = 0;  ///< larger ones say nothing
  double rounding = 0;  ///< of centres and radii of the sites, relative to both together
};

/// Nothing if the sites are so flat that the error says nothing.
std::optional<Orthosphere> orthosphere(const std::array<WeightedPoint3, 4>& sites,
                                       const OrthosphereReach& reach);

/// The centre alone, however ill-conditioned; of four centres in one plane their mean. The same
/// bits for the same sites in the same order.
Point3 orthocentre(const std::array<WeightedPoint3, 4>& sites);

/// \param tetrahedron its corners, of either orientation
bool may_conflict(const std::array<Point3, 4>& tetrahedron, const Orthosphere& sphere);

}  // namespace stream_recon
