// The points where the edges of a volume's grid cross a value.
//
// An edge joins two voxels that are neighbours along an axis; it crosses iff one end is at or above
// the value and the other below. The point is where the linear interpolation between them has the
// value. A voxel that has the value exactly is reached by up to six edges and delivered once.
//
// Guarantees: points come in the order of their lowest voxel (i fastest), no two are equal as
// doubles (a crossing closer to a voxel than 2^-40 of the edge is moved to that distance); voxels
// that are not finite cross nothing. Memory: three slices of doubles. Thread rule: one user.
#pragma once

#include <cstdint>
#include <functional>

#include "spatial/point.h"
#include "tools/slices/volume.h"

namespace stream_recon {

using PointConsumer = std::function<void(const Point3&)>;

/// Hands every crossing to `consume`; returns their number.
/// \throw what the volume throws
std::uint64_t scan_iso_points(Volume& volume, double value, const PointConsumer& consume);

}  // namespace stream_recon
