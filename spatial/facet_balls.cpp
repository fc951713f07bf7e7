#include "spatial/facet_balls.h"

#include <algorithm>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <limits>
#include <optional>

#include "spatial/binary128.h"

namespace stream_recon {
namespace {

// With b, c, d relative to the facet's first point, d the apex, N = b x c, D = N.d:
//   twice |N|^2 times the centre of the facet's circle is  W = |b|^2 (c x N) + |c|^2 (N x b),
//   the height of the ball's centre above the plane is     (|N|^2 |d|^2 - d.W) / (2 |N| D),
//   the radius of the circle is                            |b| |c| |c - b| / (2 |N|).
// The same formulas climb a ladder: double, long double, 113 bits, rational; a rung is believed
// when its forward error bound is within kTolerance of the ball's radius.

using Quad = Binary128;
using Rational = boost::multiprecision::cpp_rational;

constexpr double kTolerance = 1e-10;

// Lengths in this range can be raised to the sixth power without leaving the doubles.
constexpr double kSmallest = 1e-40;
constexpr double kLargest = 1e40;

template <class T>
struct Vector {
  T x, y, z;
};

template <class T>
Vector<T> difference(const Point3& p, const Point3& origin) {
  return {T(p.x) - T(origin.x), T(p.y) - T(origin.y), T(p.z) - T(origin.z)};
}

template <class T>
T dot(const Vector<T>& a, const Vector<T>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

template <class T>
Vector<T> cross(const Vector<T>& a, const Vector<T>& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/// What a facet contributes to the heights of both balls.
template <class T>
struct FacetFrame {
  explicit FacetFrame(const std::array<Point3, 3>& facet)
      : origin(facet[0]), b(difference<T>(facet[1], origin)), c(difference<T>(facet[2], origin)) {
    const T bb = dot(b, b);
    const T cc = dot(c, c);
    const Vector<T> edge = difference<T>(facet[2], facet[1]);
    normal = cross(b, c);
    normal_squared = dot(normal, normal);
    const Vector<T> u = cross(c, normal);
    const Vector<T> v = cross(normal, b);
    centre = {bb * u.x + cc * v.x, bb * u.y + cc * v.y, bb * u.z + cc * v.z};
    product_squared = static_cast<double>(T(bb * cc * dot(edge, edge)));
    longest = std::sqrt(static_cast<double>(std::max(bb, cc)));
    product = std::sqrt(static_cast<double>(T(bb * cc)));
  }

  double radius() const {
    return std::sqrt(product_squared / static_cast<double>(normal_squared)) / 2;
  }

  Point3 origin;
  Vector<T> b, c;
  Vector<T> normal;
  T normal_squared;
  Vector<T> centre;
  double product_squared;  ///< (|b| |c| |c - b|)^2
  double product;          ///< |b| |c|
  double longest;          ///< max(|b|, |c|)
};

/// The height of the ball through the facet and `apex`, or nothing if `unit_roundoff` (0: exact
/// arithmetic) does not allow the tolerance.
template <class T>
std::optional<double> ball_height(const FacetFrame<T>& facet, const Point3& apex,
                                  double unit_roundoff) {
  const Vector<T> d = difference<T>(apex, facet.origin);
  const T dd = dot(d, d);
  const T volume = dot(facet.normal, d);
  if (volume == 0) return std::nullopt;
  const T quotient = (facet.normal_squared * dd - dot(d, facet.centre)) / volume;

  const double numerator_over_volume = static_cast<double>(quotient);
  const double normal = std::sqrt(static_cast<double>(facet.normal_squared));
  if (unit_roundoff > 0) {
    const double size = std::abs(static_cast<double>(volume));
    const double length = std::sqrt(static_cast<double>(dd));
    const double volume_error = 16 * unit_roundoff * facet.product * length / size;
    const double normal_error = 8 * unit_roundoff * facet.product / normal;
    const double error = 2 * std::abs(numerator_over_volume) * (volume_error + normal_error) +
                         25 * unit_roundoff * facet.product * facet.product * length *
                             (2 * facet.longest + length) / size;
    const double ball =
        std::sqrt(facet.product_squared + numerator_over_volume * numerator_over_volume);
    const bool accurate =
        volume_error < 0.01 && normal_error < kTolerance / 4 && error < kTolerance / 2 * ball;
    if (!accurate) return std::nullopt;
  }
  const double height = numerator_over_volume / (2 * normal);
  return volume > 0 ? height : -height;
}

double accurate_ball_height(const std::array<Point3, 3>& facet, const Point3& apex) {
  constexpr double kExtended = std::numeric_limits<long double>::epsilon() / 2;
  const FacetFrame<long double> extended(facet);
  if (const auto height = ball_height(extended, apex, kExtended)) return *height;
  if (const auto height = ball_height(FacetFrame<Quad>(facet), apex, 0x1p-113)) return *height;
  return ball_height(FacetFrame<Rational>(facet), apex, 0).value();
}

double largest_offset(const std::array<Point3, 3>& facet) {
  double largest = 0;
  for (const Point3& p : {facet[1], facet[2]}) {
    largest = std::max({largest, std::abs(p.x - facet[0].x), std::abs(p.y - facet[0].y),
                        std::abs(p.z - facet[0].z)});
  }
  return largest;
}

/// Whether the radius is within 1e-11 of itself: the normal is within 8 roundings of the product.
template <class T>
bool knows_radius(const FacetFrame<T>& frame, double unit_roundoff) {
  const double normal = std::sqrt(static_cast<double>(frame.normal_squared));
  return normal > 0x1p40 * unit_roundoff * frame.product;
}

/// The facet's radius from the first rung that knows its normal well enough.
double facet_radius(const std::array<Point3, 3>& facet, const FacetFrame<double>& frame) {
  constexpr double kExtended = std::numeric_limits<long double>::epsilon() / 2;
  if (std::sqrt(frame.normal_squared) > 1e-4 * frame.product) return frame.radius();
  const FacetFrame<long double> extended(facet);
  if (knows_radius(extended, kExtended)) return extended.radius();
  const FacetFrame<Quad> quad(facet);
  if (knows_radius(quad, 0x1p-113)) return quad.radius();
  return FacetFrame<Rational>(facet).radius();
}

FacetBalls balls_at_unit_scale(const std::array<Point3, 3>& facet, const Point3* apex_one,
                               const Point3* apex_two) {
  const FacetFrame<double> frame(facet);
  FacetBalls balls;
  balls.radius = facet_radius(facet, frame);
  const Point3* const apexes[2] = {apex_one, apex_two};
  for (int i = 0; i < 2; ++i) {
    if (apexes[i] == nullptr) {
      balls.height[i] = FacetBalls::kHalfSpace;
    } else {
      const auto height = ball_height(frame, *apexes[i], 0x1p-53);
      balls.height[i] = height ? *height : accurate_ball_height(facet, *apexes[i]);
    }
  }
  return balls;
}

/// Scales by a power of two, which is exact, where the powers of tiny or huge lengths would leave
/// the range of doubles.
FacetBalls balls(std::array<Point3, 3> facet, const Point3& apex_one, const Point3* apex_two) {
  const double size = largest_offset(facet);
  if (size > kSmallest && size < kLargest) return balls_at_unit_scale(facet, &apex_one, apex_two);

  const int exponent = std::ilogb(size);
  const auto scaled = [exponent, origin = facet[0]](const Point3& p) {
    return Point3{std::scalbn(p.x - origin.x, -exponent), std::scalbn(p.y - origin.y, -exponent),
                  std::scalbn(p.z - origin.z, -exponent)};
  };
  for (int i : {2, 1, 0}) facet[i] = scaled(facet[i]);
  const Point3 one = scaled(apex_one);
  const Point3 two = apex_two != nullptr ? scaled(*apex_two) : Point3{};
  FacetBalls result = balls_at_unit_scale(facet, &one, apex_two != nullptr ? &two : nullptr);
  result.radius = std::scalbn(result.radius, exponent);
  for (double& height : result.height) height = std::scalbn(height, exponent);
  return result;
}

}  // namespace

FacetBalls facet_balls(const std::array<Point3, 3>& facet, const Point3& apex_one,
                       const Point3& apex_two) {
  return balls(facet, apex_one, &apex_two);
}

FacetBalls hull_facet_balls(const std::array<Point3, 3>& facet, const Point3& apex) {
  return balls(facet, apex, nullptr);
}

}  // namespace stream_recon
