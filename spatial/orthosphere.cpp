#include "spatial/orthosphere.h"

#include <algorithm>
#include <cmath>

#include "spatial/vector.h"

namespace stream_recon {
namespace {

constexpr double kUnit = 0x1p-53;

double largest(double a, double b, double c, double d) {
  return std::max(std::max(std::fabs(a), std::fabs(b)), std::max(std::fabs(c), std::fabs(d)));
}

/// The equations of the centre z relative to the first site: 2 d_j.z = |d_j|^2 - w_j + w_0.
struct CentreEquations {
  std::array<Point3, 3> d;
  std::array<double, 3> half;
  std::array<Point3, 3> rows;  ///< of the inverse, times the volume
  double volume;

  explicit CentreEquations(const std::array<WeightedPoint3, 4>& sites) {
    for (int j = 0; j < 3; ++j) {
      d[j] = minus(sites[j + 1].point, sites[0].point);
      half[j] = (dot(d[j], d[j]) - sites[j + 1].weight + sites[0].weight) / 2;
    }
    rows = {cross(d[1], d[2]), cross(d[2], d[0]), cross(d[0], d[1])};
    volume = dot(d[0], rows[0]);
  }

  Point3 solution() const {
    Point3 z;
    for (int j = 0; j < 3; ++j) z = plus(z, scaled(rows[j], half[j] / volume));
    return z;
  }
};

}  // namespace

// What the solution misses at the other sites is an affine function of the ball's centre: at the
// sites it is the residual, elsewhere it grows with the gradient.
std::optional<Orthosphere> orthosphere(const std::array<WeightedPoint3, 4>& sites,
                                       const OrthosphereReach& reach) {
  const CentreEquations equations(sites);
  if (equations.volume == 0) return std::nullopt;
  const Point3 z = equations.solution();
  double residual = 0;
  double gradient = 0;
  for (int i = 0; i < 4; ++i) {
    const double radius = std::sqrt(std::fabs(sites[i].weight));
    const double far = i == 0 ? length(z) : length(minus(z, equations.d[i - 1]));
    const double size = length(sites[i].point) + radius;
    double missed = 8 * (reach.rounding + kUnit) * size * (far + radius);
    if (i > 0) {
      const int j = i - 1;
      missed += 2 * std::fabs(equations.half[j] - dot(equations.d[j], z));
      gradient += length(equations.rows[j]) / std::fabs(equations.volume);
    }
    residual = std::max(residual, missed);
  }
  const double error = residual * (1 + 2 * gradient * reach.reach);
  if (!(error < reach.most_error)) return std::nullopt;
  return Orthosphere{plus(sites[0].point, z), dot(z, z) - sites[0].weight, error};
}

Point3 orthocentre(const std::array<WeightedPoint3, 4>& sites) {
  const CentreEquations equations(sites);
  const Point3 centre = plus(sites[0].point, equations.solution());
  if (equations.volume != 0 && is_finite(centre)) return centre;
  Point3 mean;
  for (const WeightedPoint3& site : sites) mean = plus(mean, scaled(site.point, 0.25));
  return mean;
}

// With rows u_i = p_i - z, the power of z to the circumsphere is - |u, u.u| / |u, 1|.
bool may_conflict(const std::array<Point3, 4>& p, const Orthosphere& sphere) {
  const Point3 a = minus(p[0], sphere.centre);
  const Point3 b = minus(p[1], sphere.centre);
  const Point3 c = minus(p[2], sphere.centre);
  const Point3 d = minus(p[3], sphere.centre);
  const Point3 cd = cross(c, d);
  const Point3 ab = cross(a, b);
  const double bcd = dot(b, cd);
  const double acd = dot(a, cd);
  const double abd = dot(ab, d);
  const double abc = dot(ab, c);
  const double la = dot(a, a);
  const double lb = dot(b, b);
  const double lc = dot(c, c);
  const double ld = dot(d, d);
  const double volume = (acd - bcd) + (abc - abd);
  const double lifted = (lb * acd - la * bcd) + (ld * abc - lc * abd);
  const double box =
      largest(a.x, b.x, c.x, d.x) * largest(a.y, b.y, c.y, d.y) * largest(a.z, b.z, c.z, d.z);
  const double volume_error = 64 * kUnit * box;
  if (std::fabs(volume) <= 4 * volume_error) return true;
  const double lift = largest(la, lb, lc, ld);
  const double limit = sphere.weight + sphere.error;
  const double slack = 128 * kUnit * box * (lift + std::fabs(limit));
  return (volume > 0 ? -lifted : lifted) < limit * std::fabs(volume) + slack;
}

}  // namespace stream_recon
