// What the incremental kernel needs to know of the two kinds of sites it triangulates: points, and
// points with weights.
//
// Guarantees: scaling by a power of two is exact within the range of CoordinateRange; a weight is
// the square of a length and scales as one. Thread rule: pure functions.
#pragma once

#include "spatial/point.h"
#include "spatial/vector.h"

namespace stream_recon {

inline const Point3& position(const Point3& site) {
  return site;
}
inline const Point3& position(const WeightedPoint3& site) {
  return site.point;
}

inline WeightedPoint3 scaled(const WeightedPoint3& site, double factor) {
  return {scaled(site.point, factor), site.weight * factor * factor};
}

}  // namespace stream_recon
