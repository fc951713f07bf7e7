// A region of the crust, merged into the samples of its hole.
//
// Vertices on walks have their samples. Every sample inside the hole takes the nearest of the
// others as its seed, and the rest goes to the nearest sample whose part it touches, after it was
// attracted to the samples (spatial/attraction.h): so what goes to a sample hangs together.
// Guarantees: the boundary of the result is the image of the region's. Triangles of two corners are
// dropped and opposite ones cancel. Thread rule: pure. Memory: 60 bytes a triangle of the region.
// Cost: n log n.
#pragma once

#include <cstdint>
#include <vector>

#include "engine/hybrid/crust_mesh.h"
#include "engine/hybrid/hole.h"
#include "spatial/attraction.h"

namespace stream_recon {

struct MergeOptions {
  AttractionOptions attraction;  ///< its unit is taken times the mean side of the fills
  std::size_t attracting = 8;    ///< samples that a vertex feels, the nearest: others add < 1e-6
};

/// \param region triangles of the crust
/// \param sample_of of each vertex of the crust, or kNoHolePoint: of the region's those on walks
/// \return triangles of points of the hole
std::vector<HoleTriangle> merged_patch(const Hole& hole, const CrustMesh& crust,
                                       const std::vector<std::uint32_t>& region,
                                       std::vector<std::uint32_t> sample_of,
                                       const MergeOptions& options = {});

/// The triangles that are left when opposite ones cancel and those of two corners are dropped, in
/// order, each from its lowest corner. One may be there twice.
std::vector<HoleTriangle> reduced_chain(const std::vector<HoleTriangle>& triangles);

}  // namespace stream_recon
