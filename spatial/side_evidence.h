// How much the balls around a facet, or at a sample, say about inside and outside.
//
// Two tetrahedra across a facet lie on the same side of the surface where their balls meet deeply:
// there is room through the facet. The two poles of a sample lie on opposite sides where their
// balls stand against each other. What is small against the spacing of the samples says little:
// there the samples look like a volume, as boundary voxels do, not like a surface.
// Guarantees: odds from 0 to 2^51, 1 for nothing known; functions of the arguments alone, bit for
// bit: only additions, products, quotients and roots. Thread rule: pure. Cost: about 20 ns.
// Source: ball angles as in Kolluri, Shewchuk, O'Brien, Spectral Surface Reconstruction from Noisy
// Point Clouds, 2004; weighing by the spacing is ours (docs/algorithms/labels.md).
#pragma once

#include <array>

#include "spatial/point.h"

namespace stream_recon {

/// The two empty balls through a facet, seen from its first corner. Of which side the first is
/// makes no difference.
struct FacetSides {
  std::array<Point3, 2> corners;  ///< the second and the third
  /// Centres; of a half-space, which comes second, any vector out of it at right angles to the
  /// facet.
  std::array<Point3, 2> centres;
  bool is_hull = false;
};

/// That both tetrahedra of a facet lie on the same side.
/// \param spacing the largest of the facet's samples, > 0, in the unit of the balls
double same_side_evidence(const FacetSides& balls, double spacing);

struct PoleBalls {
  double cosine = 0;  ///< 1 where the poles lie in opposite directions, at least 0
  double radius = 0;  ///< of the smaller ball
};

/// That the two poles of a sample lie on opposite sides. \param spacing of the sample, > 0, in the
/// unit of the balls
double opposite_evidence(const PoleBalls& poles, double spacing);

}  // namespace stream_recon
