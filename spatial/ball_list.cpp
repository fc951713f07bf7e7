#include "spatial/ball_list.h"

#include <algorithm>
#include <bit>
#include <cmath>

#if defined(__x86_64__)
#include <immintrin.h>
#endif

namespace stream_recon {
namespace {

// Distances are believed to this relative precision only.
constexpr double kKeep = 1 - 1e-13;
constexpr double kLateralSlack = 1e-14;

using Lower = std::array<double, BallList::kMost>;

[[gnu::always_inline]] inline double outside(double low, double high, double at) {
  const double below = low - at;
  const double above = at - high;
  const double most = below > above ? below : above;
  return most > 0 ? most : 0;
}

// Squared distances from the centres to the box.
[[gnu::always_inline]] inline void box_distances(const BallList& balls, const NodeFrame& node,
                                                 Lower& squared) {
  for (std::size_t i = 0; i < balls.count; ++i) {
    const double dx = outside(node.low.x, node.high.x, balls.x[i]);
    const double dy = outside(node.low.y, node.high.y, balls.y[i]);
    const double dz = outside(node.low.z, node.high.z, balls.z[i]);
    squared[i] = dx * dx + dy * dy + dz * dz;
  }
}

// Squared distances to the disc. The lateral part is a difference of squares: what rounding may
// have added is taken off.
[[gnu::always_inline]] inline void disc_distances(const BallList& balls, const NodeFrame& node,
                                                  Lower& squared) {
  for (std::size_t i = 0; i < balls.count; ++i) {
    const double vx = balls.x[i] - node.middle.x;
    const double vy = balls.y[i] - node.middle.y;
    const double vz = balls.z[i] - node.middle.z;
    const double vv = vx * vx + vy * vy + vz * vz;
    const double along = vx * node.normal.x + vy * node.normal.y + vz * node.normal.z;
    const double off = outside(node.slab_low, node.slab_high, along);
    const double rest = vv * (1 - kLateralSlack) - along * along * node.inverse_normal_squared;
    const double lateral = std::sqrt(rest > 0 ? rest : 0) - node.radius;
    const double beside = lateral > 0 ? lateral : 0;
    squared[i] = off * off * node.inverse_normal_squared + beside * beside;
  }
}

/// A bit a ball.
using Kept = std::array<std::uint64_t, BallList::kMost / 64>;

[[gnu::always_inline]] inline void compare_portable(const BallList& balls, const Lower& lower,
                                                    Kept& kept) {
  for (std::size_t word = 0; word * 64 < balls.count; ++word) {
    kept[word] = 0;
    for (std::size_t i = word * 64; i < std::min(balls.count, word * 64 + 64); ++i) {
      kept[word] |= std::uint64_t{lower[i] * kKeep <= balls.squared[i]} << i % 64;
    }
  }
}

// Copies only what stays, about every third: a loop over set bits beats one over all balls.
[[gnu::always_inline]] inline void copy_kept(const BallList& in, const Kept& kept, BallList& out) {
  std::size_t count = 0;
  for (std::size_t word = 0; word * 64 < in.count; ++word) {
    for (std::uint64_t bits = kept[word]; bits != 0; bits &= bits - 1) {
      const std::size_t i = word * 64 + static_cast<std::size_t>(std::countr_zero(bits));
      out.x[count] = in.x[i];
      out.y[count] = in.y[i];
      out.z[count] = in.z[i];
      out.squared[count] = in.squared[i];
      out.id[count++] = in.id[i];
    }
  }
  out.count = count;
}

void touching_portable(const BallList& in, const NodeFrame& node, BallList& out) {
  alignas(32) Lower lower;
  Kept kept;
  box_distances(in, node, lower);
  compare_portable(in, lower, kept);
  copy_kept(in, kept, out);
  if (out.count == 0) return;
  disc_distances(out, node, lower);
  compare_portable(out, lower, kept);
  copy_kept(out, kept, out);
}

#if defined(__x86_64__)
// The last comparisons may read beyond count: what is there is masked out.
__attribute__((target("avx2"))) inline void compare_avx2(const BallList& balls, const Lower& lower,
                                                         Kept& kept) {
  const __m256d keep = _mm256_set1_pd(kKeep);
  for (std::size_t word = 0; word * 64 < balls.count; ++word) {
    std::uint64_t bits = 0;
    const std::size_t end = std::min<std::size_t>(64, balls.count - word * 64);
    for (std::size_t i = 0; i < end; i += 4) {
      const __m256d distance = _mm256_mul_pd(_mm256_load_pd(&lower[word * 64 + i]), keep);
      const __m256d radius = _mm256_load_pd(&balls.squared[word * 64 + i]);
      const int four = _mm256_movemask_pd(_mm256_cmp_pd(distance, radius, _CMP_LE_OQ));
      bits |= std::uint64_t{static_cast<unsigned>(four)} << i;
    }
    kept[word] = end == 64 ? bits : bits & ((std::uint64_t{1} << end) - 1);
  }
}

__attribute__((target("avx2"))) void touching_avx2(const BallList& in, const NodeFrame& node,
                                                   BallList& out) {
  alignas(32) Lower lower;
  Kept kept;
  box_distances(in, node, lower);
  compare_avx2(in, lower, kept);
  copy_kept(in, kept, out);
  if (out.count == 0) return;
  disc_distances(out, node, lower);
  compare_avx2(out, lower, kept);
  copy_kept(out, kept, out);
}
#endif

using Touching = void (*)(const BallList&, const NodeFrame&, BallList&);

Touching select() {
#if defined(__x86_64__)
  if (__builtin_cpu_supports("avx2")) return touching_avx2;
#endif
  return touching_portable;
}

}  // namespace

void touching(const BallList& in, const NodeFrame& node, BallList& out) {
  static const Touching fastest = select();
  fastest(in, node, out);
}

}  // namespace stream_recon
