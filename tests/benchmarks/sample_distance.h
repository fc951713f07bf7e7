// How far samples lie from the surface of a known solid.
//
// A sample's distance is taken along a normal of the surface: first along the one that the solid
// has for the sample itself, then along that of the place where this one met the surface. Never
// below the distance, and close to it where the surface is nearly flat as far as the sample is off.
// Thread rule: pure. Cost: about 100 questions to the solid a sample.
#pragma once

#include <algorithm>
#include <span>

#include "spatial/point.h"
#include "spatial/vector.h"
#include "tools/clouds/known_solid.h"

namespace stream_recon {

/// \param direction of length 1 \param reach is returned if the surface is farther \pre reach > 0
inline double distance_along(const KnownSolid& solid, const Point3& from, const Point3& direction,
                             double reach) {
  const bool inside = solid.contains(from);
  const auto stays = [&](double t) {
    return solid.contains(plus(from, scaled(direction, t))) == inside;
  };
  double low = 0;
  double high = reach / 64;
  while (stays(high)) {
    if (high >= reach) return reach;
    low = high;
    high = std::min(1.5 * high, reach);
  }
  for (int halvings = 0; halvings < 30; ++halvings) {
    const double middle = (low + high) / 2;
    (stays(middle) ? low : high) = middle;
  }
  return low;
}

/// Of all samples. \param reach farther ones count as this far, > 0 \pre at least one sample
inline double mean_distance(const KnownSolid& solid, std::span<const Point3> samples,
                            double reach) {
  double sum = 0;
  for (const Point3& p : samples) {
    const double sign = solid.contains(p) ? 1 : -1;
    Point3 direction = scaled(solid.outward_normal(p), sign);
    const double first = distance_along(solid, p, direction, reach);
    direction = scaled(solid.outward_normal(plus(p, scaled(direction, first))), sign);
    sum += std::min(first, distance_along(solid, p, direction, reach));
  }
  return sum / static_cast<double>(samples.size());
}

}  // namespace stream_recon
