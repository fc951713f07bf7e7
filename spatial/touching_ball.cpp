#include "spatial/touching_ball.h"

#include <algorithm>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <limits>
#include <numbers>
#include <optional>

#include "spatial/binary128.h"
#include "spatial/double_double.h"

namespace stream_recon {
namespace {

namespace wide = boost::multiprecision;

/// Holds all sums and products of coordinates here: these have 390 bits, products of four are
/// summed.
using Exact = wide::number<
    wide::cpp_bin_float<2048, wide::digit_base_2, void, std::int32_t, -(1 << 20), 1 << 20>,
    wide::et_off>;

template <class T>
struct Number {
  static T of(double value) { return T(value); }
  static double to_double(const T& value) { return static_cast<double>(value); }
};
template <>
struct Number<DoubleDouble> {
  static DoubleDouble of(double value) { return {value, 0}; }
  static double to_double(const DoubleDouble& value) { return value.value(); }
};

template <class T>
struct Vector {
  T x, y, z;
};

template <class T>
T dot(const Vector<T>& a, const Vector<T>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

template <class T>
Vector<T> cross(const Vector<T>& a, const Vector<T>& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/// The tetrahedron where nothing overflows: its longest edge at the first point is about 1.
struct Scaled {
  std::array<Point3, 4> points;
  int exponent;  ///< of the power of two that the coordinates were multiplied by

  explicit Scaled(const std::array<Point3, 4>& tetrahedron) : points(tetrahedron), exponent(0) {
    double largest = 0;
    for (const Point3& p : points) largest = std::max(largest, magnitude(p));
    shift(-std::ilogb(largest));
    double longest = 0;
    for (int i = 1; i < 4; ++i) longest = std::max(longest, magnitude(from_first(i)));
    shift(-std::ilogb(longest));
  }

  Point3 from_first(int i) const {
    return {points[i].x - points[0].x, points[i].y - points[0].y, points[i].z - points[0].z};
  }

 private:
  static double magnitude(const Point3& p) {
    return std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)});
  }
  void shift(int by) {
    for (Point3& p : points) {
      p = {std::ldexp(p.x, by), std::ldexp(p.y, by), std::ldexp(p.z, by)};
    }
    exponent += by;
  }
};

double square(const Point3& p) {
  return p.x * p.x + p.y * p.y + p.z * p.z;
}

double longest_edge(const Scaled& tetrahedron) {
  double longest = 0;
  for (int i = 1; i < 4; ++i) {
    const Point3 a = tetrahedron.from_first(i);
    longest = std::max(longest, square(a));
    for (int j = 1; j < i; ++j) {
      const Point3 b = tetrahedron.from_first(j);
      longest = std::max(longest, square({a.x - b.x, a.y - b.y, a.z - b.z}));
    }
  }
  return std::sqrt(longest);
}

struct Precision {
  double roundoff;   ///< of an operation, relative
  double tolerance;  ///< of the centre, over the radius
};

/// Centre and radius of the scaled tetrahedron, or nothing where this is not precise enough. The
/// formula and its error: spatial/circumball.cpp.
template <class T>
std::optional<TouchingBall> solve(const Scaled& tetrahedron, const Precision& precision) {
  using N = Number<T>;
  const auto& p = tetrahedron.points;
  const auto edge = [&p](int i) {
    return Vector<T>{N::of(p[i].x) - N::of(p[0].x), N::of(p[i].y) - N::of(p[0].y),
                     N::of(p[i].z) - N::of(p[0].z)};
  };
  const Vector<T> u = edge(1);
  const Vector<T> v = edge(2);
  const Vector<T> w = edge(3);
  const Vector<T> vw = cross(v, w);
  const Vector<T> wu = cross(w, u);
  const Vector<T> uv = cross(u, v);
  const T uu = dot(u, u);
  const T vv = dot(v, v);
  const T ww = dot(w, w);
  const T volume = dot(u, vw);
  const T twice = volume + volume;
  const Vector<T> centre{(uu * vw.x + vv * wu.x + ww * uv.x) / twice,
                         (uu * vw.y + vv * wu.y + ww * uv.y) / twice,
                         (uu * vw.z + vv * wu.z + ww * uv.z) / twice};
  const T radius_square = dot(centre, centre);
  const double rough = std::sqrt(N::to_double(radius_square));
  if (precision.roundoff > 0) {
    const double a = std::sqrt(N::to_double(uu));
    const double b = std::sqrt(N::to_double(vv));
    const double c = std::sqrt(N::to_double(ww));
    const double error = 32 * precision.roundoff * a * b * c;
    const double size = std::abs(N::to_double(twice));
    if (!(size > 4 * error)) return std::nullopt;
    const double centre_error = error * (a + b + c + rough) / (size - error);
    if (!(centre_error <= precision.tolerance * rough)) return std::nullopt;
  }
  TouchingBall ball;
  ball.centre = {N::to_double(N::of(p[0].x) + centre.x), N::to_double(N::of(p[0].y) + centre.y),
                 N::to_double(N::of(p[0].z) + centre.z)};
  const T rest = radius_square - N::of(rough) * N::of(rough);
  ball.radius = rough + N::to_double(rest) / (2 * rough);
  return ball;
}

TouchingBall solve(const Scaled& tetrahedron) {
  if (const auto ball = solve<DoubleDouble>(tetrahedron, {0x1p-100, 0x1p-85})) return *ball;
  if (const auto ball = solve<Binary128>(tetrahedron, {0x1p-113, 0x1p-60})) return *ball;
  return *solve<Exact>(tetrahedron, {0, 0});
}

/// Without a negative zero, so that equal numbers are equal bits.
double unscaled(double value, int exponent) {
  return std::ldexp(value, -exponent) + 0.0;
}

}  // namespace

TouchingBall touching_ball(const std::array<Point3, 4>& tetrahedron) {
  const Scaled scaled(tetrahedron);
  TouchingBall ball = solve(scaled);
  const double sine = std::min(longest_edge(scaled) / (2 * ball.radius), 1.0);
  ball.separation = static_cast<float>(2 * std::asin(sine) * (180 / std::numbers::pi));
  ball.centre = {unscaled(ball.centre.x, scaled.exponent), unscaled(ball.centre.y, scaled.exponent),
                 unscaled(ball.centre.z, scaled.exponent)};
  ball.radius = unscaled(ball.radius, scaled.exponent);
  return ball;
}

}  // namespace stream_recon
