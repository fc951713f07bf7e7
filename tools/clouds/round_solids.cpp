#include "tools/clouds/round_solids.h"

#include <algorithm>
#include <cmath>

#include "spatial/vector.h"
#include "tools/clouds/smooth_surfaces.h"
#include "tools/clouds/trigonometry.h"

namespace stream_recon {
namespace {

constexpr double kTube = 0.4;

// An orthonormal frame oblique to the axes, rational up to one rounding.
constexpr Point3 kPlateX{3.0 / 7, -6.0 / 7, 2.0 / 7};
constexpr Point3 kPlateY{6.0 / 7, 2.0 / 7, -3.0 / 7};
constexpr Point3 kPlateNormal{2.0 / 7, 3.0 / 7, 6.0 / 7};

double sphere_area(double radius) {
  return 4 * kPi * radius * radius;
}

/// The point of the circle of radius 1 around the z axis that is nearest to p.
Point3 nearest_on_ring(const Point3& p) {
  const double from_axis = std::sqrt(p.x * p.x + p.y * p.y);
  if (from_axis == 0) return {1, 0, 0};
  return {p.x / from_axis, p.y / from_axis, 0};
}

/// Uniform in the disc of radius 1 across the z axis, but for its very centre.
Point3 in_disc(Random& random) {
  for (;;) {
    const Point3 p{random.signed_unit(), random.signed_unit(), 0};
    const double square = dot(p, p);
    if (square <= 1 && square >= 1e-6) return p;
  }
}

Point3 on_circle(Random& random) {
  const Point3 p = in_disc(random);
  return scaled(p, 1 / length(p));
}

/// Uniform on the outer half of a torus around the z axis.
Point3 on_rim(Random& random, double radius, double tube_radius) {
  for (;;) {
    const Point3 tube = scaled(on_circle(random), tube_radius);
    const double distance = radius + std::abs(tube.x);
    if (random.unit() * (radius + tube_radius) >= distance) continue;
    return plus(scaled(on_circle(random), distance), {0, 0, tube.y});
  }
}

Point3 out_of_plate_frame(const Point3& p) {
  return plus(plus(scaled(kPlateX, p.x), scaled(kPlateY, p.y)), scaled(kPlateNormal, p.z));
}

/// The point of the disc of `radius` across kPlateNormal that is nearest to p.
Point3 nearest_on_disc(const Point3& p, double radius) {
  const Point3 flat = minus(p, scaled(kPlateNormal, dot(kPlateNormal, p)));
  const double from_axis = length(flat);
  return from_axis <= radius ? flat : scaled(flat, radius / from_axis);
}

}  // namespace

SphereSolid::Nearest SphereSolid::nearest(const Point3& p) const {
  const auto distance = [&p](const Sphere& sphere) {
    const double beyond = length(minus(p, sphere.center)) - sphere.radius;
    return sphere.is_cavity ? -beyond : beyond;
  };
  const Sphere* sphere = &spheres_.front();
  for (const Sphere& other : spheres_)
    if (std::abs(distance(other)) < std::abs(distance(*sphere))) sphere = &other;
  return {*sphere, distance(*sphere)};
}

double SphereSolid::signed_bound(const Point3& p) const {
  return nearest(p).distance;
}

Point3 SphereSolid::outward_normal(const Point3& p) const {
  const Sphere& sphere = nearest(p).sphere;
  const Point3 arm = minus(p, sphere.center);
  return scaled(arm, (sphere.is_cavity ? -1 : 1) / length(arm));
}

// One sphere alone takes no number for the choice: the sphere's points are as old as the kind.
std::optional<Point3> SphereSolid::try_surface_point(Random& random) const {
  const Sphere* chosen = &spheres_.back();
  if (spheres_.size() > 1) {
    double rest = random.unit() * truth().area;
    for (const Sphere& sphere : spheres_) {
      rest -= sphere_area(sphere.radius);
      if (rest >= 0) continue;
      chosen = &sphere;
      break;
    }
  }
  return plus(chosen->center, scaled(random.direction(), chosen->radius));
}

SolidTruth SphereSolid::truth() const {
  SolidTruth sum{};
  for (const Sphere& sphere : spheres_) {
    const double area = sphere_area(sphere.radius);
    sum.volume += (sphere.is_cavity ? -1 : 1) * area * sphere.radius / 3;
    sum.area += area;
    sum.euler += 2;
  }
  return sum;
}

double SphereSolid::reach() const {
  double reach = 0;
  for (const Sphere& sphere : spheres_)
    reach = std::max(reach, length(sphere.center) + sphere.radius);
  return reach;
}

double TorusSolid::signed_bound(const Point3& p) const {
  return length(minus(p, nearest_on_ring(p))) - kTube;
}

Point3 TorusSolid::outward_normal(const Point3& p) const {
  const Point3 arm = minus(p, nearest_on_ring(p));
  return scaled(arm, 1 / length(arm));
}

std::optional<Point3> TorusSolid::try_surface_point(Random& random) const {
  const std::optional<Point3> p = try_torus_point(random);
  if (is_even_ || !p) return p;
  const double share = (p->x + reach()) / (2 * reach());
  const double distance = 1 + 3 * share;  // of neighbouring samples, in units of the least
  if (random.unit() * distance * distance >= 1) return std::nullopt;
  return p;
}

SolidTruth TorusSolid::truth() const {
  return {2 * kPi * kPi * kTube * kTube, 4 * kPi * kPi * kTube, 0};
}

double TorusSolid::reach() const {
  return 1 + kTube;
}

double PlateSolid::signed_bound(const Point3& p) const {
  return length(minus(p, nearest_on_disc(p, disc_))) - half_;
}

Point3 PlateSolid::outward_normal(const Point3& p) const {
  const Point3 arm = minus(p, nearest_on_disc(p, disc_));
  return scaled(arm, 1 / length(arm));
}

std::optional<Point3> PlateSolid::try_surface_point(Random& random) const {
  const double flat_area = 2 * kPi * disc_ * disc_;
  if (random.unit() * truth().area >= flat_area)
    return out_of_plate_frame(on_rim(random, disc_, half_));
  const double side = random.unit() < 0.5 ? -1 : 1;
  return out_of_plate_frame(plus(scaled(in_disc(random), disc_), {0, 0, side * half_}));
}

// Steiner's formula for the points within half_ of a disc.
SolidTruth PlateSolid::truth() const {
  const double disc_area = kPi * disc_ * disc_;
  const double edge = 2 * kPi * disc_;
  return {
      2 * disc_area * half_ + edge * kPi / 2 * half_ * half_ + 4 * kPi / 3 * half_ * half_ * half_,
      2 * disc_area + edge * kPi * half_ + sphere_area(half_), 2};
}

}  // namespace stream_recon
