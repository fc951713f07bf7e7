#include "spatial/local_spacing.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "spatial/direction_gaps.h"
#include "spatial/principal_plane.h"
#include "spatial/vector.h"

namespace stream_recon {
namespace {

/// The neighbour whose distance is the spacing of even samples, from 1.
constexpr std::size_t kEven = 6;

/// The part of a neighbour's vector that must lie in the plane, squared.
constexpr double kLeastInPlane = 0.25;

/// Axes of the plane in which the sample and its neighbours extend most.
std::array<Point3, 2> plane_of(std::span<const Point3> neighbors) {
  Point3 sum{};
  Moments moments;
  for (const Point3& v : neighbors) {
    sum = plus(sum, v);
    moments.add(v);
  }
  moments.subtract(sum, 1 / static_cast<double>(neighbors.size() + 1));
  return across(least_direction(moments.normalized()));
}

/// In which directions the neighbours lie, as seen from the sample.
class View {
 public:
  explicit View(std::span<const Point3> neighbors) : axes_(plane_of(neighbors)) {}

  void add(const Point3& vector) {
    const double u = dot(vector, axes_[0]);
    const double w = dot(vector, axes_[1]);
    const double in_plane = u * u + w * w;
    if (in_plane < kLeastInPlane * dot(vector, vector)) return;
    const double share = 1 / std::sqrt(in_plane);
    gaps_.add(u * share, w * share);
  }

  bool surrounds() const { return gaps_.count() > 0 && gaps_.wide() == 0; }
  bool is_rim() const { return gaps_.wide() == 1; }

 private:
  std::array<Point3, 2> axes_;
  DirectionGaps gaps_;
};

float to_float(double value) {
  using Limits = std::numeric_limits<float>;
  return static_cast<float>(std::clamp(value, double{Limits::min()}, double{Limits::max()}));
}

}  // namespace

float local_spacing(std::span<const Point3> neighbors) {
  if (neighbors.empty()) return 1;
  neighbors = neighbors.first(std::min(neighbors.size(), kSpacingNeighbors));
  const std::size_t even = std::min(neighbors.size(), kEven) - 1;
  View view(neighbors);
  std::size_t rim = 0;
  for (std::size_t i = 0; i < neighbors.size(); ++i) {
    view.add(neighbors[i]);
    if (i < even) continue;
    if (view.surrounds()) return to_float(length(neighbors[i]));
    if (rim == 0 && view.is_rim()) rim = i;
  }
  return to_float(length(neighbors[std::max(rim, even)]));
}

}  // namespace stream_recon
