#include "tools/clouds/wavy_solids.h"

#include <algorithm>

#include "spatial/vector.h"
#include "tools/clouds/folded_solid.h"
#include "tools/clouds/smooth_surfaces.h"
#include "tools/clouds/trigonometry.h"

namespace stream_recon {
namespace {

constexpr double kLowestBlobRadius = 0.8;

// Bounds the slope of |p| - r(p / |p|) where |p| >= 0.7: the waves rise by at most 0.76 there.
constexpr double kSteepestBlob = 1.5;

// The gradient's three components are products of two unit vectors each; their squares sum to at
// most 3 k^2.
constexpr double kSteepestGyroid = 1.7320508075688774 * kGyroidWave;

}  // namespace

// A straight way from p to the nearest surface point stays where |p| >= 0.7 if it begins at 0.8 or
// beyond.
double BlobSolid::signed_bound(const Point3& p) const {
  const double distance = length(p);
  if (distance < kLowestBlobRadius) return distance - kLowestBlobRadius;
  return (distance - blob_radius(scaled(p, 1 / distance)).value) / kSteepestBlob;
}

Point3 BlobSolid::outward_normal(const Point3& p) const {
  const double distance = length(p);
  const Point3 u = scaled(p, 1 / distance);
  const Point3 slope = blob_radius(u).gradient;
  const Point3 tangential = minus(slope, scaled(u, dot(slope, u)));
  const Point3 normal = minus(u, scaled(tangential, 1 / distance));
  return scaled(normal, 1 / length(normal));
}

std::optional<Point3> BlobSolid::try_surface_point(Random& random) const {
  return try_blob_point(random);
}

SolidTruth BlobSolid::truth() const {
  return {4.149224, 12.68724, 2};
}

double FoldedSolid::signed_bound(const Point3& p) const {
  const double outside_ball = length(p) - radius_;
  if (outside_ball >= 0) return outside_ball;
  return std::max(gyroid_field(p).value / kSteepestGyroid, outside_ball);
}

Point3 FoldedSolid::outward_normal(const Point3& p) const {
  const GyroidField field = gyroid_field(p);
  const bool on_ball = length(p) - radius_ > field.value / kSteepestGyroid;
  const Point3& normal = on_ball ? p : field.gradient;
  return scaled(normal, 1 / length(normal));
}

std::optional<Point3> FoldedSolid::try_surface_point(Random& random) const {
  return try_folded_surface_point(random, radius_);
}

// Reflection at the origin swaps the gyroid's sides: exactly half of the ball and of its sphere.
SolidTruth FoldedSolid::truth() const {
  const bool is_sponge = radius_ == kSpongeRadius;
  const double gyroid_area = is_sponge ? 16.016 : 19.507;
  const double square = radius_ * radius_;
  return {2 * kPi / 3 * square * radius_, 2 * kPi * square + gyroid_area, is_sponge ? -82 : -106};
}

}  // namespace stream_recon
