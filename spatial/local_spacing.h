// How large a ball around a sample must be to hold a piece of the surface: the distance of its
// eighteenth neighbour.
//
// On even samples of a surface that is about 2.4 times their distance. Eighteen is what contours on
// slices need: on slices 4 pixels apart the sixth and the twelfth neighbour still lie on the
// contour itself, and boundary voxels are two layers thick besides (docs/algorithms/spacing.md).
// Guarantees: finite, positive, and the same bits for the same vectors on every machine. Thread
// rule: pure.
// Source: ours.
#pragma once

#include <cstddef>
#include <span>

#include "spatial/point.h"

namespace stream_recon {

inline constexpr std::size_t kSpacingNeighbors = 18;

/// \param neighbors from the sample to the points nearest to it, none of them at its place, by
///        ascending length; what is beyond kSpacingNeighbors is not looked at
/// \return in the unit of the vectors: the length of the last; 1 for a sample without neighbours
float local_spacing(std::span<const Point3> neighbors);

}  // namespace stream_recon
