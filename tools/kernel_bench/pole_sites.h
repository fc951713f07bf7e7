// The poles of a cloud as weighted points: what the power crust triangulates.
//
// Guarantees: of each sample the circumcentre of its star that is farthest from it, and the
// farthest of those on its other side, seen from the first; at the hull the first lies at infinity,
// in the direction of the mean normal of the hull facets. The weight is the squared radius. A
// tetrahedron is one pole, whoever its samples are; of poles at one place the heaviest is left.
// Memory: the Delaunay structure and 100 bytes a sample. Cost: that of the Delaunay structure.
// Source: Amenta, Choi, Kolluri 2001 ("The power crust"), section 3.
#pragma once

#include <vector>

#include "spatial/point.h"

namespace stream_recon {

/// \param points distinct, in a spatially coherent order. \return by ascending place; none for
/// flat clouds. \throw InputError coordinates too far apart in magnitude
std::vector<WeightedPoint3> pole_sites(const std::vector<Point3>& points);

}  // namespace stream_recon
