// The surface has two parts. The spherical one is sampled by directions, kept where the gyroid is
// negative. The gyroid part is sampled by points of a thin layer around it, moved onto it by Newton
// steps along the gradient: a layer of one thickness everywhere gives one density, up to the factor
// 1 + K t^2 / 3 (K Gaussian curvature, t half thickness), here within 1 %.

#include "tools/clouds/folded_solid.h"

#include "spatial/vector.h"
#include "tools/clouds/trigonometry.h"

namespace stream_recon {
namespace {

constexpr double kHalfThickness = 0.02;

// Densities per area and candidate: layer 2 t / box volume, sphere 1 / its area. Choosing the
// sphere this often makes them equal.
double sphere_share(double radius) {
  const double half_box = radius + kHalfThickness;
  const double layer_density = 2 * kHalfThickness / (8 * half_box * half_box * half_box);
  return layer_density / (layer_density + 1 / (4 * kPi * radius * radius));
}

double squared_length(const Point3& p) {
  return p.x * p.x + p.y * p.y + p.z * p.z;
}

Point3 newton_step(const Point3& p, const GyroidField& field) {
  const double t = field.value / squared_length(field.gradient);
  return {p.x - t * field.gradient.x, p.y - t * field.gradient.y, p.z - t * field.gradient.z};
}

bool outside_layer(const GyroidField& field) {
  const double reach = 1.5 * kHalfThickness;
  return field.value * field.value > reach * reach * squared_length(field.gradient);
}

std::optional<Point3> try_gyroid_point(Random& random, double radius) {
  const double half_box = radius + kHalfThickness;
  const Point3 start{half_box * random.signed_unit(), half_box * random.signed_unit(),
                     half_box * random.signed_unit()};
  GyroidField field = gyroid_field(start);
  if (outside_layer(field)) return std::nullopt;
  Point3 p = start;
  for (int step = 0; step < 4; ++step) {
    p = newton_step(p, field);
    field = gyroid_field(p);
  }
  const Point3 moved{p.x - start.x, p.y - start.y, p.z - start.z};
  if (squared_length(moved) > kHalfThickness * kHalfThickness) return std::nullopt;
  if (squared_length(p) > radius * radius) return std::nullopt;
  return p;
}

}  // namespace

GyroidField gyroid_field(const Point3& p, double wave) {
  const SineCosine x = sine_cosine(wave * p.x);
  const SineCosine y = sine_cosine(wave * p.y);
  const SineCosine z = sine_cosine(wave * p.z);
  return {gyroid_value({x.sine, y.sine, z.sine}, {x.cosine, y.cosine, z.cosine}),
          {wave * (x.cosine * y.cosine - z.sine * x.sine),
           wave * (y.cosine * z.cosine - x.sine * y.sine),
           wave * (z.cosine * x.cosine - y.sine * z.sine)}};
}

std::optional<Point3> try_folded_surface_point(Random& random, double radius) {
  if (random.unit() >= sphere_share(radius)) return try_gyroid_point(random, radius);
  const Point3 p = scaled(random.direction(), radius);
  if (gyroid_field(p).value > 0) return std::nullopt;
  return p;
}

}  // namespace stream_recon
