#include "spatial/node_bounds.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "spatial/patch_fit.h"
#include "spatial/vector.h"

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

void store(const Point3& from, float (&to)[3]) {
  to[0] = static_cast<float>(from.x);
  to[1] = static_cast<float>(from.y);
  to[2] = static_cast<float>(from.z);
}

Point3 load(const float (&from)[3]) {
  return {from[0], from[1], from[2]};
}

void set_box(NodeBounds& bounds, const Point3& low, const Point3& high, double slack) {
  bounds.low[0] = round_down(low.x - slack);
  bounds.low[1] = round_down(low.y - slack);
  bounds.low[2] = round_down(low.z - slack);
  bounds.high[0] = round_up(high.x + slack);
  bounds.high[1] = round_up(high.y + slack);
  bounds.high[2] = round_up(high.z + slack);
}

struct Interval {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();

  void extend(double value) {
    low = std::min(low, value);
    high = std::max(high, value);
  }
  double magnitude() const { return std::max(std::abs(low), std::abs(high)); }
};

/// The patch of a node as it is stored: every float is taken at its word.
struct Sheet {
  Point3 middle;
  std::array<Point3, 2> rows;
  Point3 normal;
  std::array<double, 2> curvature;
  /// u, w and the height over the plane of the rows are along.v and up.v.
  std::array<Point3, 2> along;
  Point3 up;

  explicit Sheet(const NodeBounds& b)
      : middle(load(b.middle)),
        rows{load(b.rows[0]), load(b.rows[1])},
        normal(load(b.normal)),
        curvature{b.curvature[0], b.curvature[1]} {
    const Point3 area = cross(rows[0], rows[1]);
    const double share = 1 / dot(area, normal);
    along = {scaled(cross(rows[1], normal), share), scaled(cross(normal, rows[0]), share)};
    up = scaled(area, share);
  }
};

void set_frame(NodeBounds& bounds, const Patch& patch) {
  const bool is_steep = std::abs(patch.slope[0]) > 0.9 || std::abs(patch.slope[1]) > 0.9;
  store(patch.middle, bounds.middle);
  store(patch.normal, bounds.normal);
  for (int i = 0; i < 2; ++i) {
    const double slope = is_steep ? 0 : patch.slope[i];
    store(plus(patch.axes[i], scaled(patch.normal, slope)), bounds.rows[i]);
    bounds.curvature[i] = is_steep ? 0.0F : static_cast<float>(patch.curvature[i]);
    if (!std::isfinite(bounds.curvature[i])) bounds.curvature[i] = 0;
  }
}

/// \pre set_frame()
void set_extents(NodeBounds& bounds, const std::array<double, 2>& extents, double slack) {
  for (int i = 0; i < 2; ++i) {
    bounds.extent[i] = round_up(extents[i] * (1 + kSlack) + slack);
    if (std::abs(bounds.curvature[i]) * bounds.extent[i] > 1) bounds.curvature[i] = 0;
  }
}

void set_thickness(NodeBounds& bounds, const Interval& thickness, double slack) {
  bounds.thick_low = round_down(thickness.low - slack);
  bounds.thick_high = round_up(thickness.high + slack);
}

void set_patch(NodeBounds& bounds, std::span<const Point3> points, double slack) {
  set_frame(bounds, fit_patch(points));
  const Sheet frame(bounds);
  std::array<double, 2> extents{};
  for (const Point3& p : points) {
    const Point3 v = minus(p, frame.middle);
    for (int i = 0; i < 2; ++i) extents[i] = std::max(extents[i], std::abs(dot(frame.along[i], v)));
  }
  set_extents(bounds, extents, 8 * slack);
  const Sheet sheet(bounds);
  Interval thickness;
  for (const Point3& p : points) {
    const Point3 v = minus(p, sheet.middle);
    const double u = dot(sheet.along[0], v);
    const double w = dot(sheet.along[1], v);
    thickness.extend(dot(sheet.up, v) -
                     (sheet.curvature[0] * u * u + sheet.curvature[1] * w * w) / 2);
  }
  set_thickness(bounds, thickness, 8 * slack);
}

/// What a node says about its points, for the node above.
class Child {
 public:
  explicit Child(const NodeBounds& b)
      : sheet_(b),
        extent_{b.extent[0], b.extent[1]},
        thick_{b.thick_low, b.thick_high},
        rise_(thick_.magnitude()) {
    for (int i = 0; i < 2; ++i) {
      rise_ += std::abs(sheet_.curvature[i]) * extent_[i] * extent_[i] / 2;
    }
  }

  void sample(std::vector<Point3>& points) const {
    for (const double u : {-1.0, 0.0, 1.0}) {
      for (const double w : {-1.0, 0.0, 1.0}) {
        const double x = u * extent_[0];
        const double y = w * extent_[1];
        const double z =
            (thick_.low + thick_.high + sheet_.curvature[0] * x * x + sheet_.curvature[1] * y * y) /
            2;
        points.push_back(plus(plus(sheet_.middle, scaled(sheet_.normal, z)),
                              plus(scaled(sheet_.rows[0], x), scaled(sheet_.rows[1], y))));
      }
    }
  }

  /// How far along axis i of `above` a point can be.
  double extent_in(const Sheet& above, int i) const {
    const Point3& axis = above.along[i];
    return std::abs(dot(axis, minus(sheet_.middle, above.middle))) +
           extent_[0] * std::abs(dot(axis, sheet_.rows[0])) +
           extent_[1] * std::abs(dot(axis, sheet_.rows[1])) +
           rise_ * std::abs(dot(axis, sheet_.normal));
  }

  /// How far from the paraboloid of `above` points can be: a polynomial in u, w and z, bounded term
  /// by term. Terms with z^2, or z times u or w, are small where this matters.
  Interval heights_over(const Sheet& above) const {
    const Point3 away = minus(sheet_.middle, above.middle);
    const double steep = dot(above.up, sheet_.normal);
    double constant = dot(above.up, away);
    std::array<double, 2> linear{dot(above.up, sheet_.rows[0]), dot(above.up, sheet_.rows[1])};
    std::array<double, 2> square{sheet_.curvature[0] * steep / 2, sheet_.curvature[1] * steep / 2};
    double rest = 0;
    for (int i = 0; i < 2; ++i) {
      const Point3& axis = above.along[i];
      const double bend = above.curvature[i];
      const double at = dot(axis, away);
      const double p = dot(axis, sheet_.rows[0]);
      const double q = dot(axis, sheet_.rows[1]);
      const double y = rise_ * std::abs(dot(axis, sheet_.normal));
      constant -= bend * at * at / 2;
      linear[0] -= bend * at * p;
      linear[1] -= bend * at * q;
      square[0] -= bend * p * p / 2;
      square[1] -= bend * q * q / 2;
      const double most = std::abs(at) + std::abs(p) * extent_[0] + std::abs(q) * extent_[1];
      rest += std::abs(bend) * (std::abs(p * q) * extent_[0] * extent_[1] + y * (most + y));
    }
    Interval heights{constant - rest, constant + rest};
    for (int i = 0; i < 2; ++i) {
      const double tilt = std::abs(linear[i]) * extent_[i];
      const double curve = square[i] * extent_[i] * extent_[i];
      heights.low += std::min(0.0, curve) - tilt;
      heights.high += std::max(0.0, curve) + tilt;
    }
    heights.low += std::min(steep * thick_.low, steep * thick_.high);
    heights.high += std::max(steep * thick_.low, steep * thick_.high);
    return heights;
  }

 private:
  Sheet sheet_;
  std::array<double, 2> extent_;
  Interval thick_;
  double rise_;  ///< the most of |z|
};

}  // namespace

NodeBounds empty_bounds() {
  NodeBounds bounds{};
  for (int i = 0; i < 3; ++i) {
    bounds.low[i] = kInfinity;
    bounds.high[i] = -kInfinity;
  }
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
  for (const Point3& p : points) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
  set_box(bounds, low, high, kSlack * reach);
  set_patch(bounds, points, kSlack * reach);
  return bounds;
}

NodeBounds bounds_of_nodes(std::span<const NodeBounds> nodes, double reach) {
  NodeBounds bounds = empty_bounds();
  std::vector<Child> children;
  std::vector<Point3> samples;
  for (const NodeBounds& node : nodes) {
    if (node.empty()) continue;
    for (int i = 0; i < 3; ++i) {
      bounds.low[i] = std::min(bounds.low[i], node.low[i]);
      bounds.high[i] = std::max(bounds.high[i], node.high[i]);
    }
    children.emplace_back(node);
    children.back().sample(samples);
  }
  if (children.empty()) return bounds;
  set_frame(bounds, fit_patch(samples));
  const Sheet frame(bounds);
  std::array<double, 2> extents{};
  for (const Child& child : children) {
    for (int i = 0; i < 2; ++i) extents[i] = std::max(extents[i], child.extent_in(frame, i));
  }
  set_extents(bounds, extents, 8 * kSlack * reach);
  const Sheet sheet(bounds);
  Interval thickness;
  for (const Child& child : children) {
    const Interval heights = child.heights_over(sheet);
    thickness.extend(heights.low);
    thickness.extend(heights.high);
  }
  set_thickness(bounds, thickness, 8 * kSlack * (reach + thickness.magnitude()));
  return bounds;
}

}  // namespace stream_recon
