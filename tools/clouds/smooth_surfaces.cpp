#include "tools/clouds/smooth_surfaces.h"

#include <array>
#include <cmath>

#include "tools/clouds/trigonometry.h"

namespace stream_recon {
namespace {

struct Wave {
  Point3 frequency;
  double phase;
  double height;
};

constexpr std::array<Wave, 5> kBumps{{
    {{2.1, -1.3, 0.7}, 0.4, 0.060},
    {{-0.9, 2.6, 1.9}, 1.9, 0.045},
    {{3.3, 1.1, -2.2}, 2.7, 0.040},
    {{-1.7, -3.1, 2.9}, 0.9, 0.030},
    {{4.1, -2.3, 3.7}, 1.3, 0.025},
}};

double dot(const Point3& a, const Point3& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

// No candidate has a larger area factor r sqrt(r^2 + |grad r|^2).
double largest_blob_stretch() {
  double radius = 1;
  double slope = 0;
  for (const Wave& wave : kBumps) {
    radius += wave.height;
    slope += wave.height * std::sqrt(dot(wave.frequency, wave.frequency));
  }
  return radius * std::sqrt(radius * radius + slope * slope);
}

Point3 on_circle(Random& random) {
  for (;;) {
    const double x = random.signed_unit();
    const double y = random.signed_unit();
    const double square = x * x + y * y;
    if (square > 1 || square < 1e-6) continue;
    const double length = std::sqrt(square);
    return {x / length, y / length, 0};
  }
}

}  // namespace

std::optional<Point3> try_ellipsoid_point(Random& random) {
  constexpr Point3 kAxes{1, 0.7, 0.5};
  const Point3 u = random.direction();
  const Point3 slope{u.x / kAxes.x, u.y / kAxes.y, u.z / kAxes.z};
  const double stretch = std::sqrt(dot(slope, slope)) * kAxes.z;  // 1 where the area grows most
  if (random.unit() >= stretch) return std::nullopt;
  return Point3{kAxes.x * u.x, kAxes.y * u.y, kAxes.z * u.z};
}

BlobRadius blob_radius(const Point3& u) {
  double radius = 1;
  Point3 gradient;
  for (const Wave& wave : kBumps) {
    const SineCosine value = sine_cosine(dot(wave.frequency, u) + wave.phase);
    radius += wave.height * value.sine;
    gradient.x += wave.height * value.cosine * wave.frequency.x;
    gradient.y += wave.height * value.cosine * wave.frequency.y;
    gradient.z += wave.height * value.cosine * wave.frequency.z;
  }
  return {radius, gradient};
}

std::optional<Point3> try_blob_point(Random& random) {
  static const double largest_stretch = largest_blob_stretch();
  const Point3 u = random.direction();
  const auto [radius, gradient] = blob_radius(u);
  const double radial = dot(gradient, u);
  const double slope = dot(gradient, gradient) - radial * radial;  // of the part along the sphere
  const double stretch = radius * std::sqrt(radius * radius + slope);
  if (random.unit() * largest_stretch >= stretch) return std::nullopt;
  return Point3{radius * u.x, radius * u.y, radius * u.z};
}

std::optional<Point3> try_torus_point(Random& random) {
  constexpr double kTube = 0.4;
  const Point3 around = on_circle(random);
  const Point3 tube = on_circle(random);
  const double distance = 1 + kTube * tube.x;
  if (random.unit() * (1 + kTube) >= distance) return std::nullopt;
  return Point3{distance * around.x, distance * around.y, kTube * tube.y};
}

}  // namespace stream_recon
