#include "spatial/sphere_cut.h"

#include <algorithm>
#include <limits>

#include "spatial/vector.h"

namespace stream_recon {
namespace {

constexpr double kRoundoff = 0x1p-53;

}  // namespace

// With u, v, w from the first corner, V = u.(v x w) and d_i the height of the first corner less
// that of another, the gradient is (d_1 (v x w) + d_2 (w x u) + d_3 (u x v)) / V. Each cross
// product is within 4 roundings of |v| |w| a component, V within 12 of |u| |v| |w|; all taken
// double.
SphereCut cut_sphere(const Sphere& sphere, const std::array<Point3, 4>& p) {
  const Point3 u = minus(p[1], p[0]);
  const Point3 v = minus(p[2], p[0]);
  const Point3 w = minus(p[3], p[0]);
  const double a = length(u);
  const double b = length(v);
  const double c = length(w);
  const Point3 vw = cross(v, w);
  const double volume = dot(u, vw);
  const double volume_error = 32 * kRoundoff * (a * b * c);
  SphereCut cut{.origin = p[0], .gradient_error = std::numeric_limits<double>::infinity()};
  if (!(std::abs(volume) > 4 * volume_error)) return cut;

  const double first = height_over(sphere, p[0]);
  const double first_error = height_error(sphere, first);
  std::array<double, 3> fall{};
  std::array<double, 3> uncertain{};  // of a fall, and of what it is multiplied by
  for (int i = 0; i < 3; ++i) {
    const double height = height_over(sphere, p[i + 1]);
    fall[i] = first - height;
    uncertain[i] = first_error + height_error(sphere, height) + 32 * kRoundoff * std::abs(fall[i]);
  }
  const Point3 sum =
      plus(plus(scaled(vw, fall[0]), scaled(cross(w, u), fall[1])), scaled(cross(u, v), fall[2]));
  const double sum_error = uncertain[0] * (b * c) + uncertain[1] * (c * a) + uncertain[2] * (a * b);
  cut.at_origin = -first;
  cut.at_origin_error = first_error;
  cut.gradient = scaled(sum, 1 / volume);
  const double size = length(cut.gradient);
  cut.gradient_error = 2 * ((sum_error + size * volume_error) / (std::abs(volume) - volume_error) +
                            4 * kRoundoff * size);
  return cut;
}

void sharpen_powers(const Sphere& sphere, const SphereCut& cut, const PointColumns& points,
                    const LeafHeights& heights, PointPowers& powers) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < PointPowers::kPoints; ++i) {
    const double qx = points.x[i] - cut.origin.x;
    const double qy = points.y[i] - cut.origin.y;
    const double qz = points.z[i] - cut.origin.z;
    const double distance = std::abs(qx) + std::abs(qy) + std::abs(qz);
    const double linear = qx * cut.gradient.x + qy * cut.gradient.y + qz * cut.gradient.z;
    const double power = (heights[i] + cut.at_origin) + linear;
    const double error = cut.error(distance) + 2 * height_error(sphere, heights[i]);
    const bool is_better = error < powers.error[i];
    powers.power[i] = is_better ? power : powers.power[i];
    powers.error[i] = is_better ? error : powers.error[i];
    const double low = powers.power[i] - powers.error[i];
    least = low < least ? low : least;
  }
  powers.least = least;
}

}  // namespace stream_recon
