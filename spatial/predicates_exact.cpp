// The determinants in expansions, over the coordinates themselves. Where all differences to one
// point are exact (always for points that are close together or of few bits) the points are moved
// there first: then most components vanish.
#include "spatial/predicates_exact.h"

#include "spatial/expansion.h"

namespace stream_recon::detail {
namespace {

// x_a y_b - y_a x_b.
Expansion<4> cross_xy(const Point3& a, const Point3& b) {
  const Expansion<2> left = Expansion<1>(a.x) * b.y;
  const Expansion<2> right = Expansion<1>(a.y) * b.x;
  return left - right;
}

// |a b c|.
Expansion<24> volume(const Point3& a, const Point3& b, const Point3& c) {
  return cross_xy(b, c) * a.z - cross_xy(a, c) * b.z + cross_xy(a, b) * c.z;
}

// |b - a, c - a| in x and y, and |b - a, c - a, d - a|, both as |1 a; 1 b; ...|.
Expansion<12> orientation_xy(const Point3& a, const Point3& b, const Point3& c) {
  return cross_xy(b, c) - cross_xy(a, c) + cross_xy(a, b);
}
Expansion<96> orientation(const Point3& a, const Point3& b, const Point3& c, const Point3& d) {
  return (volume(b, c, d) - volume(a, c, d)) + (volume(a, b, d) - volume(a, b, c));
}

Expansion<2> square(double a) {
  return Expansion<1>(a) * a;
}

// |p|^2 - w.
Expansion<7> lift(const WeightedPoint3& p) {
  return square(p.point.x) + square(p.point.y) + square(p.point.z) - Expansion<1>(p.weight);
}

bool subtract(double& a, double b) {
  const DoublePair difference = two_sum(a, -b);
  a = difference.high;
  return difference.low == 0;
}

// Moves the origin to the last site if that rounds nothing.
template <std::size_t kSites>
std::array<WeightedPoint3, kSites> move_to_last(const std::array<WeightedPoint3, kSites>& sites) {
  std::array<WeightedPoint3, kSites> moved = sites;
  const Point3 origin = sites.back().point;
  for (auto& [point, weight] : moved) {
    if (!subtract(point.x, origin.x) || !subtract(point.y, origin.y) ||
        !subtract(point.z, origin.z)) {
      return sites;
    }
  }
  return moved;
}

}  // namespace

int exact_orient_xy(const Point3& a, const Point3& b, const Point3& c) {
  return orientation_xy(a, b, c).sign();
}

int exact_orient3d(const Point3& a, const Point3& b, const Point3& c, const Point3& d) {
  const auto moved = move_to_last<4>({{{a, 0}, {b, 0}, {c, 0}, {d, 0}}});
  return orientation(moved[0].point, moved[1].point, moved[2].point, moved[3].point).sign();
}

// Expanded along the column of the lifts: the cofactor of a corner is the orientation with the
// query in its place, that of the query is minus the orientation of the corners.
int exact_power_test(const std::array<WeightedPoint3, 5>& sites) {
  const auto moved = move_to_last(sites);
  const auto& [a, b, c, d, e] = moved;
  const auto left = orientation(e.point, b.point, c.point, d.point) * lift(a) +
                    orientation(a.point, e.point, c.point, d.point) * lift(b);
  const auto right = orientation(a.point, b.point, e.point, d.point) * lift(c) +
                     orientation(a.point, b.point, c.point, e.point) * lift(d);
  const auto query = orientation(a.point, b.point, c.point, d.point) * lift(e);
  return (left + right - query).sign();
}

int exact_power_circle_xy(const std::array<WeightedPoint3, 4>& sites) {
  const auto moved = move_to_last(sites);
  const auto& [a, b, c, d] = moved;
  const auto left = orientation_xy(d.point, b.point, c.point) * lift(a) +
                    orientation_xy(a.point, d.point, c.point) * lift(b);
  const auto right = orientation_xy(a.point, b.point, d.point) * lift(c) -
                     orientation_xy(a.point, b.point, c.point) * lift(d);
  return (left + right).sign();
}

}  // namespace stream_recon::detail
