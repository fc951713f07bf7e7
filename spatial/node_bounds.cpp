#include "spatial/node_bounds.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace stream_recon {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();

// Relative slack for the few roundings of a double computation here.
constexpr double kSlack = 1e-14;

float round_down(double value) {
  const float nearest = static_cast<float>(value);
  return nearest <= value ? nearest : std::nextafter(nearest, -kInfinity);
}

float round_up(double value) {
  return -round_down(-value);
}

double dot(const Point3& a, const Point3& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

Point3 cross(const Point3& a, const Point3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

Point3 minus(const Point3& a, const Point3& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}

/// Symmetric, and the sum over points of their outer products.
struct Moments {
  double xx = 0, xy = 0, xz = 0, yy = 0, yz = 0, zz = 0;

  void add(const Point3& v, double weight) {
    xx += weight * v.x * v.x;
    xy += weight * v.x * v.y;
    xz += weight * v.x * v.z;
    yy += weight * v.y * v.y;
    yz += weight * v.y * v.z;
    zz += weight * v.z * v.z;
  }
};

// The direction of least extent: inverse iteration by the adjugate, whose columns are what any
// start becomes after one step; two squarings make it two more doublings. Any unit vector would do
// for correctness.
Point3 least_direction(const Moments& m) {
  double a = m.yy * m.zz - m.yz * m.yz;
  double b = m.xz * m.yz - m.xy * m.zz;
  double c = m.xy * m.yz - m.xz * m.yy;
  double d = m.xx * m.zz - m.xz * m.xz;
  double e = m.xy * m.xz - m.xx * m.yz;
  double f = m.xx * m.yy - m.xy * m.xy;
  for (int step = 0; step < 3; ++step) {
    const double size = std::max({std::abs(a), std::abs(d), std::abs(f)});
    if (!(size > 0) || !std::isfinite(size)) return {0, 0, 1};
    const double s = 1 / size;
    a *= s, b *= s, c *= s, d *= s, e *= s, f *= s;
    if (step == 2) break;
    const double aa = a * a + b * b + c * c;
    const double ab = a * b + b * d + c * e;
    const double ac = a * c + b * e + c * f;
    const double dd = b * b + d * d + e * e;
    const double de = b * c + d * e + e * f;
    const double ff = c * c + e * e + f * f;
    a = aa, b = ab, c = ac, d = dd, e = de, f = ff;
  }
  Point3 column{a, b, c};
  if (d > a && d >= f) column = {b, d, e};
  if (f > a && f > d) column = {c, e, f};
  const double length = std::sqrt(dot(column, column));
  return {column.x / length, column.y / length, column.z / length};
}

void set_box(NodeBounds& bounds, const Point3& low, const Point3& high, double slack) {
  bounds.low[0] = round_down(low.x - slack);
  bounds.low[1] = round_down(low.y - slack);
  bounds.low[2] = round_down(low.z - slack);
  bounds.high[0] = round_up(high.x + slack);
  bounds.high[1] = round_up(high.y + slack);
  bounds.high[2] = round_up(high.z + slack);
}

Point3 middle_of(const NodeBounds& b) {
  return {0.5 * (double{b.low[0]} + double{b.high[0]}),
          0.5 * (double{b.low[1]} + double{b.high[1]}),
          0.5 * (double{b.low[2]} + double{b.high[2]})};
}

void set_normal(NodeBounds& bounds, const Point3& normal) {
  bounds.normal[0] = static_cast<float>(normal.x);
  bounds.normal[1] = static_cast<float>(normal.y);
  bounds.normal[2] = static_cast<float>(normal.z);
}

Point3 normal_of(const NodeBounds& b) {
  return {b.normal[0], b.normal[1], b.normal[2]};
}

/// `size`: a length that no distance inside the node exceeds.
void set_disc(NodeBounds& bounds, double low, double high, double radius, double slack) {
  bounds.slab_low = round_down(low - slack);
  bounds.slab_high = round_up(high + slack);
  bounds.radius = round_up(radius + slack);
}

}  // namespace

NodeBounds empty_bounds() {
  NodeBounds bounds{};
  for (int i = 0; i < 3; ++i) {
    bounds.low[i] = kInfinity;
    bounds.high[i] = -kInfinity;
  }
  bounds.normal[2] = 1;
  return bounds;
}

double squared_diagonal(const NodeBounds& bounds) {
  double sum = 0;
  for (int i = 0; i < 3; ++i) {
    const double side = double{bounds.high[i]} - bounds.low[i];
    sum += side * side;
  }
  return sum;
}

NodeBounds bounds_of_points(std::span<const Point3> points, double reach) {
  NodeBounds bounds = empty_bounds();
  if (points.empty()) return bounds;
  Point3 low = points[0];
  Point3 high = points[0];
  Point3 mean{};
  for (const Point3& p : points) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
    mean = {mean.x + p.x, mean.y + p.y, mean.z + p.z};
  }
  const double slack = kSlack * reach;
  set_box(bounds, low, high, slack);
  const double share = 1 / static_cast<double>(points.size());
  mean = {mean.x * share, mean.y * share, mean.z * share};
  Moments moments;
  for (const Point3& p : points) moments.add(minus(p, mean), 1);
  set_normal(bounds, least_direction(moments));

  const Point3 middle = middle_of(bounds);
  const Point3 normal = normal_of(bounds);
  const double inverse = 1 / dot(normal, normal);
  double slab_low = std::numeric_limits<double>::infinity();
  double slab_high = -slab_low;
  double lateral_squared = 0;
  for (const Point3& p : points) {
    const Point3 v = minus(p, middle);
    const double along = dot(normal, v);
    slab_low = std::min(slab_low, along);
    slab_high = std::max(slab_high, along);
    const double t = along * inverse;
    const Point3 side = minus(v, {t * normal.x, t * normal.y, t * normal.z});
    lateral_squared = std::max(lateral_squared, dot(side, side));
  }
  set_disc(bounds, slab_low, slab_high, std::sqrt(lateral_squared) * (1 + kSlack), slack);
  return bounds;
}

NodeBounds bounds_of_nodes(std::span<const NodeBounds> nodes, double reach) {
  NodeBounds bounds = empty_bounds();
  Point3 mean{};
  double count = 0;
  for (const NodeBounds& node : nodes) {
    if (node.empty()) continue;
    for (int i = 0; i < 3; ++i) {
      bounds.low[i] = std::min(bounds.low[i], node.low[i]);
      bounds.high[i] = std::max(bounds.high[i], node.high[i]);
    }
    const Point3 m = middle_of(node);
    mean = {mean.x + m.x, mean.y + m.y, mean.z + m.z};
    ++count;
  }
  if (count == 0) return bounds;
  mean = {mean.x / count, mean.y / count, mean.z / count};
  Moments moments;
  for (const NodeBounds& node : nodes) {
    if (node.empty()) continue;
    // A disc of radius r has r^2 / 4 about each axis in its plane.
    const double spread = double{node.radius} * node.radius / 4;
    const Point3 n = normal_of(node);
    moments.add(minus(middle_of(node), mean), 1);
    moments.xx += spread, moments.yy += spread, moments.zz += spread;
    moments.add(n, -spread);
  }
  set_normal(bounds, least_direction(moments));

  const Point3 middle = middle_of(bounds);
  const Point3 normal = normal_of(bounds);
  const double inverse = 1 / dot(normal, normal);
  double slab_low = std::numeric_limits<double>::infinity();
  double slab_high = -slab_low;
  double radius = 0;
  for (const NodeBounds& node : nodes) {
    if (node.empty()) continue;
    const NodeFrame child(node);
    const Point3 v = minus(child.middle, middle);
    const double along = dot(normal, v);
    // In the child's frame a point is m + (t n + s) with t in the slab over |n|^2, |s| <= radius.
    const double cosine = dot(normal, child.normal) * child.inverse_normal_squared;
    const Point3 tilt = cross(normal, child.normal);
    const double sine = std::sqrt(dot(tilt, tilt)) * (1 + 1e-6);
    const double ends[2] = {cosine * child.slab_low, cosine * child.slab_high};
    slab_low = std::min(slab_low, along + std::min(ends[0], ends[1]) - sine * child.radius);
    slab_high = std::max(slab_high, along + std::max(ends[0], ends[1]) + sine * child.radius);
    const double t = along * inverse;
    const Point3 side = minus(v, {t * normal.x, t * normal.y, t * normal.z});
    const double thick = std::max(std::abs(child.slab_low), std::abs(child.slab_high));
    radius =
        std::max(radius, std::sqrt(dot(side, side)) + child.radius + sine * thick * (1 + 1e-6));
  }
  set_disc(bounds, slab_low, slab_high, radius * (1 + kSlack), kSlack * reach);
  return bounds;
}

NodeFrame::NodeFrame(const NodeBounds& b)
    : low{b.low[0], b.low[1], b.low[2]},
      high{b.high[0], b.high[1], b.high[2]},
      middle(middle_of(b)),
      normal(normal_of(b)),
      inverse_normal_squared(1 / dot(normal, normal)),
      slab_low(b.slab_low),
      slab_high(b.slab_high),
      radius(b.radius) {}

}  // namespace stream_recon
