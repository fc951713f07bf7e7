#include "spatial/attraction.h"

#include <algorithm>
#include <limits>

#include "spatial/vector.h"

namespace stream_recon {

Point3 attracted_once(const Point3& place, std::span<const Point3> points,
                      const AttractionOptions& options) {
  if (points.empty()) return place;
  double least = std::numeric_limits<double>::infinity();
  for (const Point3& b : points) least = std::min(least, length(minus(b, place)));
  Point3 pull;
  for (const Point3& b : points) {
    const Point3 to_b = minus(b, place);
    const double base = 1 / ((length(to_b) - least) / options.unit + 1);
    const double p2 = base * base;
    const double p4 = p2 * p2;
    const double p8 = p4 * p4;
    pull = plus(pull, scaled(to_b, p8 * p8));
  }
  return plus(place, scaled(pull, options.rate / static_cast<double>(points.size())));
}

Attracted attracted(const Point3& place, std::span<const Point3> points,
                    const AttractionOptions& options) {
  Attracted result{place, points.empty()};
  for (int step = 0; step < options.most_steps && !result.is_still; ++step) {
    const Point3 next = attracted_once(result.place, points, options);
    result.is_still = length(minus(next, result.place)) < options.still * options.unit;
    result.place = next;
  }
  return result;
}

}  // namespace stream_recon
