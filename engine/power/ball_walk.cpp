#include "engine/power/ball_walk.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>

#include "spatial/circumball.h"
#include "spatial/vector.h"

namespace stream_recon {
namespace {

/// Fewer, and many are computed again and again.
constexpr std::size_t kBallsASample = 6;
constexpr std::size_t kLeastBalls = 1 << 10;

constexpr double kFloat = 0x1p-24;
constexpr double kDouble = 0x1p-53;

double sum(const Point3& a) {
  return std::fabs(a.x) + std::fabs(a.y) + std::fabs(a.z);
}

}  // namespace

BallWalk::BallWalk(const CertifiedWindow& samples)
    : samples_(samples),
      balls_(std::bit_ceil(std::max(kLeastBalls, kBallsASample * samples.view().owned_count()))) {}

void BallWalk::begin() {
  cells_ = samples_.view().delaunay().view();
  const std::size_t slots = cells_.slots();
  if (stamps_.capacity() < slots) stamps_.reserve(slots + slots / 8);
  stamps_.resize(slots);
  ++number_;
  walk_.clear();
  looked_at_ = 0;
}

void BallWalk::add(CellId cell) {
  walk_.push_back(cell);
  cells_.prefetch(cell);
}

// All together, so that memory is fetched for many at a time.
const std::vector<CellId>& BallWalk::step() {
  neighbors_.clear();
  for (; looked_at_ < walk_.size(); ++looked_at_) {
    for (int side = 0; side < 4; ++side) {
      const CellId next = cells_.neighbor(walk_[looked_at_], side);
      prefetch(next);
      neighbors_.push_back(next);
    }
  }
  return neighbors_;
}

BallWalk::Kind BallWalk::kind_of_unknown(CellId cell) const {
  if (!samples_.is_final(cell)) return Kind::kNotFinal;
  return cells_.is_infinite(cell) ? Kind::kInfinite : Kind::kBounded;
}

bool BallWalk::in_conflict(CellId cell) {
  Ball& ball = balls_[cell & (balls_.size() - 1)];
  if (ball.cell != cell) ball = ball_of(cell);
  const Point3 q = minus(sphere_.centre, cells_.point(ball.corner));
  const double square = dot(q, q);
  const double limit = sphere_.weight + sphere_.error;
  const double over = square - 2 * (ball.x * q.x + ball.y * q.y + ball.z * q.z) - limit;
  const double error = ball.error * sum(q) + 16 * kDouble * (square + std::fabs(limit));
  if (over > error) return false;
  if (over < -error) return true;
  return may_conflict(cells_.corners(cell), sphere_);
}

// Only of final cells, which are never destroyed.
BallWalk::Ball BallWalk::ball_of(CellId cell) const {
  const Circumball known = circumball(cells_.corners(cell));
  const Point3& r = known.centre;
  Ball ball{.cell = cell,
            .corner = cells_.vertex(cell, 0),
            .x = static_cast<float>(r.x),
            .y = static_cast<float>(r.y),
            .z = static_cast<float>(r.z)};
  const double of_floats = 2 * kFloat * std::max({std::fabs(r.x), std::fabs(r.y), std::fabs(r.z)});
  ball.error = static_cast<float>(1.0001 * (of_floats + known.linear_error()) + 0x1p-126);
  // What floats do not hold is left to may_conflict().
  if (!(std::isfinite(ball.error) && std::isfinite(ball.x + ball.y + ball.z))) {
    ball.x = ball.y = ball.z = 0;
    ball.error = std::numeric_limits<float>::infinity();
  }
  return ball;
}

std::uint64_t BallWalk::bytes() const {
  return balls_.capacity() * sizeof(Ball) + stamps_.capacity() * sizeof(std::uint32_t) +
         (walk_.capacity() + neighbors_.capacity()) * sizeof(CellId);
}

}  // namespace stream_recon
