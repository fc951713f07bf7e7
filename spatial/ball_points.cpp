#include "spatial/ball_points.h"

#include <cmath>
#include <limits>

namespace stream_recon {
namespace {

[[gnu::always_inline]] inline void powers_by_loop(const Circumball& ball,
                                                  const PointColumns& points, PointPowers& out) {
  const double linear = ball.linear_error();
  const Point3 a = ball.origin;
  const Point3 c{2 * ball.centre.x, 2 * ball.centre.y, 2 * ball.centre.z};
  alignas(32) std::array<double, PointPowers::kPoints> low;
  for (std::size_t i = 0; i < PointPowers::kPoints; ++i) {
    const double qx = points.x[i] - a.x;
    const double qy = points.y[i] - a.y;
    const double qz = points.z[i] - a.z;
    const double qq = qx * qx + qy * qy + qz * qz;
    const double sum = std::abs(qx) + std::abs(qy) + std::abs(qz);
    out.power[i] = qq - (qx * c.x + qy * c.y + qz * c.z);
    out.error[i] = sum * linear + qq * Circumball::kQuadraticError;
    low[i] = out.power[i] - out.error[i];
  }
  double least = std::numeric_limits<double>::infinity();
  for (const double value : low) least = value < least ? value : least;
  out.least = least;
}

void powers_portable(const Circumball& ball, const PointColumns& points, PointPowers& out) {
  powers_by_loop(ball, points, out);
}

#if defined(__x86_64__)
__attribute__((target("avx2"))) void powers_avx2(const Circumball& ball, const PointColumns& points,
                                                 PointPowers& out) {
  powers_by_loop(ball, points, out);
}
#endif

using Powers = void (*)(const Circumball&, const PointColumns&, PointPowers&);

Powers select() {
#if defined(__x86_64__)
  if (__builtin_cpu_supports("avx2")) return powers_avx2;
#endif
  return powers_portable;
}

}  // namespace

void powers_of_points(const Circumball& ball, const PointColumns& points, PointPowers& out) {
  static const Powers fastest = select();
  fastest(ball, points, out);
}

}  // namespace stream_recon
