#include "engine/surface/ranked_points.h"

#include <stdexcept>

namespace stream_recon {
namespace {

/// Brings the points to where the predicates are exact; their range there.
CoordinateRange scale(std::vector<Point3>& points) {
  CoordinateRange range;
  for (const Point3& p : points) range.extend(p);
  const std::optional<double> power = range.scale();
  if (!power) throw std::logic_error("points are too far apart in magnitude for exact tests");
  for (Point3& p : points) p = {p.x * *power, p.y * *power, p.z * *power};
  return range.times(*power);
}

}  // namespace

RankedPoints::RankedPoints(std::vector<PointRank> ranks, std::vector<Point3> points)
    : ranks_(std::move(ranks)), points_(std::move(points)), predicates_(scale(points_)) {}

}  // namespace stream_recon
