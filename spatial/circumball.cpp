#include "spatial/circumball.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "spatial/binary128.h"

namespace stream_recon {
namespace {

// A centre this well known, in units of the radius, makes the search no slower.
constexpr double kTolerance = 1e-8;

template <class T>
struct Vector {
  T x, y, z;
};

/// (p - a) 2^exponent
template <class T>
Vector<T> difference(const Point3& p, const Point3& a, int exponent) {
  Vector<T> d{T(p.x) - T(a.x), T(p.y) - T(a.y), T(p.z) - T(a.z)};
  if (exponent == 0) return d;
  // One power of two may be beyond the doubles.
  const T half = T(std::ldexp(1.0, exponent / 2));
  const T rest = T(std::ldexp(1.0, exponent - exponent / 2));
  return {d.x * half * rest, d.y * half * rest, d.z * half * rest};
}

// Edges in this range can be raised to the fourth power, and that times a rounding, in doubles.
constexpr double kSmallest = 1e-60;
constexpr double kLargest = 1e60;

double longest_side(const std::array<Point3, 4>& p) {
  double longest = 0;
  for (int i = 1; i < 4; ++i) {
    longest = std::max(
        {longest, std::abs(p[i].x - p[0].x), std::abs(p[i].y - p[0].y), std::abs(p[i].z - p[0].z)});
  }
  return longest;
}

template <class T>
T dot(const Vector<T>& a, const Vector<T>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

template <class T>
Vector<T> cross(const Vector<T>& a, const Vector<T>& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

template <class T>
double to_double(const T& value) {
  return static_cast<double>(value);
}

// With u, v, w from the first vertex and V = u.(v x w), the centre is
//   (|u|^2 (v x w) + |v|^2 (w x u) + |w|^2 (u x v)) / (2 V).
// Forward error: each cross product is within 4 roundings of |v| |w| a component, so V is within 12
// of |u| |v| |w| and the numerator within 12 of |u| |v| |w| (|u| + |v| + |w|) a component.
template <class T>
Circumball solve(const std::array<Point3, 4>& p, int exponent, double roundoff) {
  const Vector<T> u = difference<T>(p[1], p[0], exponent);
  const Vector<T> v = difference<T>(p[2], p[0], exponent);
  const Vector<T> w = difference<T>(p[3], p[0], exponent);
  const Vector<T> vw = cross(v, w);
  const Vector<T> wu = cross(w, u);
  const Vector<T> uv = cross(u, v);
  const T uu = dot(u, u);
  const T vv = dot(v, v);
  const T ww = dot(w, w);
  const T twice = 2 * dot(u, vw);
  Circumball ball{p[0], {}, std::numeric_limits<double>::infinity()};
  const double volume = std::abs(to_double(twice));
  const double a = std::sqrt(to_double(uu));
  const double b = std::sqrt(to_double(vv));
  const double c = std::sqrt(to_double(ww));
  const double size = a * b * c;
  const double volume_error = 32 * roundoff * size;
  if (!(volume > 4 * volume_error)) return ball;
  ball.centre = {to_double(T((uu * vw.x + vv * wu.x + ww * uv.x) / twice)),
                 to_double(T((uu * vw.y + vv * wu.y + ww * uv.y) / twice)),
                 to_double(T((uu * vw.z + vv * wu.z + ww * uv.z) / twice))};
  const double numerator_error = 32 * roundoff * size * (a + b + c);
  const double radius = ball.radius();
  ball.centre_error =
      (numerator_error + radius * volume_error) / (volume - volume_error) + 4 * 0x1p-53 * radius;
  return ball;
}

bool is_good(const Circumball& ball) {
  return ball.centre_error <= kTolerance * ball.radius() && std::isfinite(ball.centre_error);
}

}  // namespace

Circumball circumball(const std::array<Point3, 4>& tetrahedron) {
  const double longest = longest_side(tetrahedron);
  const bool is_usual = longest > kSmallest && longest < kLargest;
  const int exponent = is_usual ? 0 : -std::ilogb(longest);
  Circumball ball = solve<double>(tetrahedron, exponent, 0x1p-53);
  if (!is_good(ball)) {
    ball =
        solve<long double>(tetrahedron, exponent, std::numeric_limits<long double>::epsilon() / 2);
  }
  if (!is_good(ball)) ball = solve<Binary128>(tetrahedron, exponent, 0x1p-113);
  if (exponent != 0) {
    ball.centre = {std::ldexp(ball.centre.x, -exponent), std::ldexp(ball.centre.y, -exponent),
                   std::ldexp(ball.centre.z, -exponent)};
    ball.centre_error = std::ldexp(ball.centre_error, -exponent);
  }
  return ball;
}

}  // namespace stream_recon
