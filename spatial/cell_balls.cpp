#include "spatial/cell_balls.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace stream_recon {
namespace detail {
namespace {

// With b, c, d the vectors from the first vertex to the others, D = b.(c x d) and
// C = |b|^2 (c x d) + |c|^2 (d x b) + |d|^2 (b x c), the centre is C / 2D from the first vertex.
// The facet opposite b sees it at height A / |D| P of its radius, where A = C.(c x d) and P is the
// product of the facet's three edges; the A of all four facets add up to 2 D^2.
// docs/algorithms/gamma.md derives the error bounds.

constexpr double kRoundoff = 0x1p-53;
constexpr double kVolumeError = 10 * kRoundoff;  ///< of D, over |b| |c| |d|
constexpr double kCentreError = 16 * kRoundoff;  ///< of C, over |b| |c| |d| (|b| + |c| + |d|)
constexpr double kHeightError = 32 * kRoundoff;  ///< of A, over that times |c| |d|
constexpr double kShare = BallEstimate::kError / 4;

// Squares of lengths in this range can be raised to the fourth power within the doubles.
constexpr double kSmallestSquare = 1e-64;
constexpr double kLargestSquare = 1e64;
constexpr double kLargestHeight = 1e30;  ///< over the facet's radius: within the floats

struct Vector {
  double x, y, z;
};

#define STREAM_RECON_INLINE inline __attribute__((always_inline))

STREAM_RECON_INLINE Vector cross(const Vector& a, const Vector& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
STREAM_RECON_INLINE double dot(const Vector& a, const Vector& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
STREAM_RECON_INLINE double least(double a, double b) {
  return a < b ? a : b;
}
STREAM_RECON_INLINE double most(double a, double b) {
  return a > b ? a : b;
}
STREAM_RECON_INLINE Vector edge(const BallLanes& lanes, std::size_t lane, int from, int to) {
  return {lanes.x[to][lane] - lanes.x[from][lane], lanes.y[to][lane] - lanes.y[from][lane],
          lanes.z[to][lane] - lanes.z[from][lane]};
}

// The height that a facet sees, NaN where `is_safe` is not or A is not known well enough.
STREAM_RECON_INLINE double height(double a, double a_error, double volume, double edges_squared,
                                  bool is_safe) {
  const double below = volume * __builtin_sqrt(edges_squared);
  const bool is_sure = is_safe & (a_error <= kShare * most(below, __builtin_fabs(a))) &
                       (__builtin_fabs(a) <= kLargestHeight * below);
  const double quotient = a / below;
  return is_sure ? quotient : std::numeric_limits<double>::quiet_NaN();
}

STREAM_RECON_INLINE void estimate_lane(BallLanes& lanes, std::size_t lane) {
  const Vector b = edge(lanes, lane, 0, 1);
  const Vector c = edge(lanes, lane, 0, 2);
  const Vector d = edge(lanes, lane, 0, 3);
  const Vector e = edge(lanes, lane, 1, 2);
  const Vector f = edge(lanes, lane, 1, 3);
  const Vector g = edge(lanes, lane, 2, 3);
  const double bb = dot(b, b);
  const double cc = dot(c, c);
  const double dd = dot(d, d);
  const double ee = dot(e, e);
  const double ff = dot(f, f);
  const double gg = dot(g, g);
  const Vector cd = cross(c, d);
  const Vector db = cross(d, b);
  const Vector bc = cross(b, c);
  const double volume = __builtin_fabs(dot(b, cd));
  const Vector centre = {bb * cd.x + cc * db.x + dd * bc.x, bb * cd.y + cc * db.y + dd * bc.y,
                         bb * cd.z + cc * db.z + dd * bc.z};
  const double a1 = dot(centre, cd);
  const double a2 = dot(centre, db);
  const double a3 = dot(centre, bc);
  const double a0 = 2 * volume * volume - a1 - a2 - a3;

  const double bl = __builtin_sqrt(bb);
  const double cl = __builtin_sqrt(cc);
  const double dl = __builtin_sqrt(dd);
  const double product = bl * cl * dl;
  const double size = product * (bl + cl + dl);
  const double e1 = kHeightError * size * (cl * dl);
  const double e2 = kHeightError * size * (dl * bl);
  const double e3 = kHeightError * size * (bl * cl);

  const double shortest = least(least(least(bb, cc), least(dd, ee)), least(ff, gg));
  const double longest = most(most(most(bb, cc), most(dd, ee)), most(ff, gg));
  const bool is_safe = (shortest > kSmallestSquare) & (longest < kLargestSquare) &
                       (kVolumeError * product <= kShare * volume);
  lanes.height[0][lane] = height(a0, e1 + e2 + e3, volume, ee * ff * gg, is_safe);
  lanes.height[1][lane] = height(a1, e1, volume, cc * dd * gg, is_safe);
  lanes.height[2][lane] = height(a2, e2, volume, bb * dd * ff, is_safe);
  lanes.height[3][lane] = height(a3, e3, volume, bb * cc * ee, is_safe);

  const double centre_length = __builtin_sqrt(dot(centre, centre));
  const bool is_radius_sure = is_safe & (kCentreError * size <= kShare * centre_length);
  lanes.radius[lane] =
      is_radius_sure ? centre_length / (2 * volume) : std::numeric_limits<double>::quiet_NaN();
}

STREAM_RECON_INLINE void estimate_all(BallLanes& lanes) {
  for (std::size_t lane = 0; lane < BallLanes::kCount; ++lane) estimate_lane(lanes, lane);
}

}  // namespace

void estimate_lanes_portable(BallLanes& lanes) {
  estimate_all(lanes);
}

#if defined(__x86_64__)
__attribute__((target("avx2"))) void estimate_lanes_avx2(BallLanes& lanes) {
  estimate_all(lanes);
}
#endif

BallKernel select_ball_kernel() {
#if defined(__x86_64__)
  if (__builtin_cpu_supports("avx2")) return estimate_lanes_avx2;
#endif
  return estimate_lanes_portable;
}

}  // namespace detail

using detail::BallLanes;

BallEstimator::BallEstimator(const CellView& cells)
    : cells_(cells), kernel_(detail::select_ball_kernel()), lanes_{} {}

void BallEstimator::estimate(std::span<const CellId> cells, std::span<CellBall> results) {
  for (std::size_t i = 0; i < cells.size(); i += BallLanes::kCount) {
    const std::size_t count = std::min(BallLanes::kCount, cells.size() - i);
    estimate_batch(cells.subspan(i, count), results.subspan(i, count));
  }
}

// Lanes beyond the batch keep what they had and are not read.
void BallEstimator::estimate_batch(std::span<const CellId> cells, std::span<CellBall> results) {
  for (std::size_t lane = 0; lane < cells.size(); ++lane) {
    for (int i = 0; i < 4; ++i) {
      const Point3& p = cells_.stored_point(cells_.vertex(cells[lane], i));
      lanes_.x[i][lane] = p.x;
      lanes_.y[i][lane] = p.y;
      lanes_.z[i][lane] = p.z;
    }
  }
  kernel_(lanes_);
  // A cloud of extreme numbers is left to the accurate balls.
  const double unknown = cells_.is_unscaled() ? 0 : std::numeric_limits<double>::quiet_NaN();
  for (std::size_t lane = 0; lane < cells.size(); ++lane) {
    CellBall& ball = results[lane];
    for (int i = 0; i < 4; ++i) {
      ball.heights[i] = static_cast<float>(lanes_.height[i][lane] + unknown);
    }
    ball.radius = lanes_.radius[lane] + unknown;
  }
}

}  // namespace stream_recon
