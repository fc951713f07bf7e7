// First rung of the power tests: determinants in doubles with a bound of their error.
//
// Guarantees: as predicates_filter.h, which counts the error of the in-sphere test: the lift of a
// row is s + t with s = |row|^2 and t the difference of the weights. It has one rounding more, and
// |s| + |t| stands for the largest lift.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "spatial/determinants.h"
#include "spatial/point.h"
#include "spatial/predicates_filter.h"

namespace stream_recon {

struct PowerEstimate : Estimate {
  /// The largest |s| + |t|.
  double top;

  /// Whether `value` is the determinant itself. \param reach_limit differences up to this make an
  /// in-sphere determinant exact: its lifts are at most 3 reach_limit^2.
  bool is_exact(double reach_limit) const {
    return reach <= reach_limit && top <= 3 * reach_limit * reach_limit;
  }
};

namespace detail {

/// Error of estimate_power_test() over the product of the largest differences and the largest
/// |s| + |t|: 24 * 17 u.
inline constexpr double kPowerError = 416 * kRoundoff;
/// The same in a plane: 6 * 13 u.
inline constexpr double kPowerCircleError = 81 * kRoundoff;

/// A site as seen from another one.
struct LiftedRow {
  Point3 row;
  double lift;
  double top;

  LiftedRow(const WeightedPoint3& site, const WeightedPoint3& from)
      : row(difference(site.point, from.point)) {
    const double square = squared_length(row);
    const double weight = from.weight - site.weight;
    lift = square + weight;
    top = square + std::fabs(weight);
  }
};

}  // namespace detail

/// Positive if the last site is closer than orthogonal to the sphere orthogonal to the others.
inline PowerEstimate estimate_power_test(const WeightedPoint3& a, const WeightedPoint3& b,
                                         const WeightedPoint3& c, const WeightedPoint3& d,
                                         const WeightedPoint3& query) {
  const detail::LiftedRow p(a, query);
  const detail::LiftedRow q(b, query);
  const detail::LiftedRow r(c, query);
  const detail::LiftedRow s(d, query);
  const double x = detail::largest(p.row.x, q.row.x, r.row.x, s.row.x);
  const double y = detail::largest(p.row.y, q.row.y, r.row.y, s.row.y);
  const double z = detail::largest(p.row.z, q.row.z, r.row.z, s.row.z);
  const double top = std::max(std::max(p.top, q.top), std::max(r.top, s.top));
  const detail::Lifts<double> lifts{p.lift, q.lift, r.lift, s.lift};
  return {{detail::lifted_determinant(p.row, q.row, r.row, s.row, lifts),
           detail::kPowerError * (x * y * z * top), std::max(std::max(x, y), z)},
          top};
}

/// The same for four sites of one plane, relative to the orientation of a, b, c in x and y.
inline Estimate estimate_power_circle_xy(const WeightedPoint3& a, const WeightedPoint3& b,
                                         const WeightedPoint3& c, const WeightedPoint3& query) {
  const detail::LiftedRow p(a, query);
  const detail::LiftedRow q(b, query);
  const detail::LiftedRow r(c, query);
  const double x = detail::largest(p.row.x, q.row.x, r.row.x);
  const double y = detail::largest(p.row.y, q.row.y, r.row.y);
  const double top = detail::largest(p.top, q.top, r.top);
  const detail::Lifts<double> lifts{p.lift, q.lift, r.lift};
  return {detail::lifted_determinant_xy(p.row, q.row, r.row, lifts),
          detail::kPowerCircleError * (x * y * top), std::max(x, y)};
}

}  // namespace stream_recon
