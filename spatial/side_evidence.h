// How much the balls around a facet, or at a sample, say about inside and outside.
//
// Two tetrahedra across a facet lie on the same side of the surface where their balls meet deeply:
// there is room through the facet. The two poles of a sample lie on opposite sides where their
// balls stand against each other. What is small against the spacing of the samples says little:
// there the samples look like a volume, as boundary voxels do, not like a surface.
// Guarantees: weights in [0, 2], 1 for nothing known; functions of the arguments alone, bit for
// bit: only additions, products, quotients and roots. Thread rule: pure. Cost: about 20 ns.
// Source: ball angles as in Kolluri, Shewchuk, O'Brien, Spectral Surface Reconstruction from Noisy
// Point Clouds, 2004; weighing by the spacing is ours (docs/algorithms/labels.md).
#pragma once

#include "spatial/facet_balls.h"

namespace stream_recon {

/// That both tetrahedra of a facet lie on the same side.
/// \param spacing the largest of the facet's samples, > 0, units of the input
double same_side_evidence(const FacetBalls& balls, double spacing);

struct PoleBalls {
  double cosine = 0;  ///< 1 where the poles lie in opposite directions, at least 0
  double radius = 0;  ///< of the smaller ball, units of the input
};

/// That the two poles of a sample lie on opposite sides. \param spacing of the sample, > 0
double opposite_evidence(const PoleBalls& poles, double spacing);

}  // namespace stream_recon
