#include "spatial/ball_list.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <optional>

#include "spatial/vector.h"

#if defined(__x86_64__)
#include <immintrin.h>
#endif

namespace stream_recon {
namespace {

// The error analysis is in docs/algorithms/index.md.
constexpr double kRoundoff = 0x1p-24;  // of floats
constexpr double kRegionError = 4 * kRoundoff;
constexpr double kPowerError = 16 * kRoundoff;
constexpr double kDoubleError = 32 * 0x1p-53;

/// What a test in floats may be off, besides what the region is off itself. \param away of the
/// middle from the origin \param extents the sum of all half sizes of what is tested
double test_error(double away, double extents) {
  const double r = 1 + away;
  return kRoundoff * (11 * (r * r - 1) + 48 * r * extents + 64 * extents * extents);
}

// A bound on floats computed from doubles.
constexpr double kUp = 1 + 2 * kRoundoff;

// Patches thinner than this share of their extents are tested alone: their boxes tell no more.
constexpr double kThin = 0.125;

/// The power less what is uncertain about the region. NaN: where nothing is known.
float least_power(double power) {
  return static_cast<float>(power - kRegionError - kPowerError * std::abs(power));
}

using Lanes [[gnu::vector_size(4 * BallList::kLanes)]] = float;
using LaneMask [[gnu::vector_size(4 * BallList::kLanes)]] = std::int32_t;

/// A direction a, as which lanes see it: c.a - lift (m.a) for the middle m of what is tested.
struct Direction {
  float x, y, z, offset;

  Direction(const Point3& a, const Point3& middle)
      : x(static_cast<float>(a.x)),
        y(static_cast<float>(a.y)),
        z(static_cast<float>(a.z)),
        offset(static_cast<float>(dot(a, middle))) {}
};

/// The middle m of what is tested: the power there is power - 2 c.m + lift |m|^2.
struct Middle {
  float x, y, z, squared;

  explicit Middle(const Point3& m)
      : x(static_cast<float>(2 * m.x)),
        y(static_cast<float>(2 * m.y)),
        z(static_cast<float>(2 * m.z)),
        squared(static_cast<float>(dot(m, m))) {}
};

Point3 middle_in(const Point3& p, const ListFrame& frame) {
  return scaled(minus(p, frame.origin), frame.inverse_unit);
}

/// What a test of the patch uses, in the units of the frame.
struct PatchTest {
  PatchTest(const NodeBounds& b, const ListFrame& frame)
      : at(middle_in({b.middle[0], b.middle[1], b.middle[2]}, frame)),
        middle(at),
        normal({b.normal[0], b.normal[1], b.normal[2]}, at),
        rows{{{b.rows[0][0], b.rows[0][1], b.rows[0][2]}, at},
             {{b.rows[1][0], b.rows[1][1], b.rows[1][2]}, at}} {
    const double scale = frame.inverse_unit;
    const double low = b.thick_low * scale;
    const double high = b.thick_high * scale;
    double extents = std::max(std::abs(low), std::abs(high));
    for (int i = 0; i < 2; ++i) {
      curvature[i] = static_cast<float>(b.curvature[i] * frame.unit);
      extent[i] = static_cast<float>(b.extent[i] * scale * kUp);
      extents += extent[i];
    }
    error = static_cast<float>(test_error(length(at), extents));
    is_thin = high - low < kThin * (double{extent[0]} + extent[1]);
    thick_low = static_cast<float>(low);
    thick_high = static_cast<float>(high);
  }

  Point3 at;
  Middle middle;
  Direction normal;
  Direction rows[2];
  float curvature[2];
  float extent[2];
  float thick_low, thick_high;
  float error;
  bool is_thin;
};

struct BoxTest {
  BoxTest(const NodeBounds& b, const ListFrame& frame)
      : at(middle_in({0.5 * (double{b.low[0]} + b.high[0]), 0.5 * (double{b.low[1]} + b.high[1]),
                      0.5 * (double{b.low[2]} + b.high[2])},
                     frame)),
        middle(at),
        centre{static_cast<float>(at.x), static_cast<float>(at.y), static_cast<float>(at.z)} {
    double extents = 0;
    for (int i = 0; i < 3; ++i) {
      extent[i] =
          static_cast<float>(0.5 * (double{b.high[i]} - b.low[i]) * frame.inverse_unit * kUp);
      extents += extent[i];
    }
    error = static_cast<float>(test_error(length(at), extents));
  }

  Point3 at;
  Middle middle;
  float centre[3];
  float extent[3];
  float error;
};

struct Block {
  Lanes x, y, z, lift, power;
};

[[gnu::always_inline]] inline void load(
    const std::array<float, BallList::kMost + BallList::kLanes>& from, std::size_t i, Lanes& to) {
  __builtin_memcpy(&to, &from[i], sizeof(to));
}

[[gnu::always_inline]] inline void load(const BallList& balls, std::size_t i, Block& block) {
  load(balls.x, i, block.x);
  load(balls.y, i, block.y);
  load(balls.z, i, block.z);
  load(balls.lift, i, block.lift);
  load(balls.power, i, block.power);
}

// The least of a t^2 - 2 b t over |t| <= extent. Where a is not positive it is at an end.
[[gnu::always_inline]] inline void add_least(const Lanes& a, const Lanes& inverse_a, const Lanes& b,
                                             float extent, Lanes& sum) {
  const Lanes size = b < 0 ? -b : b;
  const Lanes end = extent + Lanes{};
  const Lanes t = size < a * extent ? size * inverse_a : end;
  sum += t * (a * t - 2 * size);
}

// The lanes that may be not positive somewhere on the patch.
[[gnu::always_inline]] inline void reach_patch(const Block& l, const PatchTest& test,
                                               LaneMask& reach) {
  Lanes least = l.power - (l.x * test.middle.x + l.y * test.middle.y + l.z * test.middle.z) +
                l.lift * test.middle.squared - test.error;
  const Direction& n = test.normal;
  const Lanes along = l.x * n.x + l.y * n.y + l.z * n.z - l.lift * n.offset;
  for (int i = 0; i < 2; ++i) {
    const Direction& row = test.rows[i];
    const Lanes across = l.x * row.x + l.y * row.y + l.z * row.z - l.lift * row.offset;
    const Lanes bend = l.lift - along * test.curvature[i];
    add_least(bend, 1 / bend, across, test.extent[i], least);
  }
  const Lanes low = along * test.thick_low;
  const Lanes high = along * test.thick_high;
  least -= 2 * (low > high ? low : high);
  reach = ~(least > 0);
}

[[gnu::always_inline]] inline void reach_box(const Block& l, const BoxTest& test, LaneMask& reach) {
  Lanes least = l.power - (l.x * test.middle.x + l.y * test.middle.y + l.z * test.middle.z) +
                l.lift * test.middle.squared - test.error;
  const Lanes inverse = 1 / l.lift;
  add_least(l.lift, inverse, l.x - l.lift * test.centre[0], test.extent[0], least);
  add_least(l.lift, inverse, l.y - l.lift * test.centre[1], test.extent[1], least);
  add_least(l.lift, inverse, l.z - l.lift * test.centre[2], test.extent[2], least);
  reach = ~(least > 0);
}

#if defined(__x86_64__)
/// For each set of lanes, a byte each, where those of it come from when they are moved to the
/// front.
constexpr std::array<std::uint64_t, 256> kFront = [] {
  std::array<std::uint64_t, 256> table{};
  for (unsigned mask = 0; mask < 256; ++mask) {
    unsigned place = 0;
    for (std::uint64_t lane = 0; lane < 8; ++lane) {
      if ((mask >> lane & 1) != 0) table[mask] |= lane << 8 * place++;
    }
  }
  return table;
}();

__attribute__((target("avx2"))) inline unsigned bits_of(const LaneMask& mask) {
  __m256 lanes;
  __builtin_memcpy(&lanes, &mask, sizeof(lanes));
  return static_cast<unsigned>(_mm256_movemask_ps(lanes));
}

/// Copies the lanes that `bits` names, and others behind them.
__attribute__((target("avx2"))) inline void copy_lanes(const BallList& in, std::size_t i,
                                                       unsigned bits, BallList& out) {
  const __m256i front =
      _mm256_cvtepu8_epi32(_mm_cvtsi64_si128(static_cast<std::int64_t>(kFront[bits])));
  const std::array<const float*, 5> from{&in.x[i], &in.y[i], &in.z[i], &in.lift[i], &in.power[i]};
  const std::size_t at = out.count;
  const std::array<float*, 5> to{&out.x[at], &out.y[at], &out.z[at], &out.lift[at], &out.power[at]};
  for (std::size_t k = 0; k < from.size(); ++k) {
    _mm256_storeu_ps(to[k], _mm256_permutevar8x32_ps(_mm256_load_ps(from[k]), front));
  }
  __m256i ids;
  __builtin_memcpy(&ids, &in.id[i], sizeof(ids));
  ids = _mm256_permutevar8x32_epi32(ids, front);
  __builtin_memcpy(&out.id[at], &ids, sizeof(ids));
  out.count += static_cast<std::size_t>(std::popcount(bits));
}
#endif

using Touching = void (*)(const BallList&, const NodeBounds&, const ListFrame&, BallList&);

Touching select() {
#if defined(__x86_64__)
  if (__builtin_cpu_supports("avx2")) return detail::touching_avx2;
#endif
  return detail::touching_portable;
}

}  // namespace

namespace detail {

void touching_portable(const BallList& in, const NodeBounds& node, const ListFrame& frame,
                       BallList& out) {
  const PatchTest patch(node, frame);
  std::optional<BoxTest> box;
  if (!patch.is_thin) box.emplace(node, frame);
  out.count = 0;
  for (std::size_t i = 0; i < in.count; i += BallList::kLanes) {
    Block block;
    load(in, i, block);
    LaneMask kept;
    reach_patch(block, patch, kept);
    if (box) {
      LaneMask reach;
      reach_box(block, *box, reach);
      kept &= reach;
    }
    for (std::size_t lane = 0; lane < std::min(BallList::kLanes, in.count - i); ++lane) {
      const std::size_t k = i + lane;
      if (kept[lane] == 0) continue;
      out.push({in.x[k], in.y[k], in.z[k], in.lift[k], in.power[k]}, in.id[k]);
    }
  }
}

#if defined(__x86_64__)
__attribute__((target("avx2"))) void touching_avx2(const BallList& in, const NodeBounds& node,
                                                   const ListFrame& frame, BallList& out) {
  const PatchTest patch(node, frame);
  std::optional<BoxTest> box;
  if (!patch.is_thin) box.emplace(node, frame);
  out.count = 0;
  for (std::size_t i = 0; i < in.count; i += BallList::kLanes) {
    Block block;
    load(in, i, block);
    const std::size_t left = in.count - i;
    unsigned bits = left < BallList::kLanes ? (1U << left) - 1 : 0xffU;
    LaneMask reach;
    if (box) {
      reach_box(block, *box, reach);
      bits &= bits_of(reach);
      if (bits == 0) continue;
    }
    reach_patch(block, patch, reach);
    bits &= bits_of(reach);
    if (bits != 0) copy_lanes(in, i, bits, out);
  }
}
#endif

}  // namespace detail

ListFrame::ListFrame(const NodeBounds& b)
    : origin{0.5 * (double{b.low[0]} + b.high[0]), 0.5 * (double{b.low[1]} + b.high[1]),
             0.5 * (double{b.low[2]} + b.high[2])},
      unit(0.5 * std::sqrt(squared_diagonal(b)) * kUp) {
  if (!(unit > 0)) unit = 1;
  inverse_unit = 1 / unit;
}

Region ball_in(const ListFrame& frame, const Point3& centre, double squared_radius) {
  const Point3 c = minus(centre, frame.origin);
  const double away = dot(c, c);
  const double size = std::max(std::sqrt(away), frame.unit);
  const double share = 1 / size;
  const double power = away - squared_radius - kDoubleError * (away + squared_radius);
  return {static_cast<float>(c.x * share), static_cast<float>(c.y * share),
          static_cast<float>(c.z * share), static_cast<float>(frame.unit * share),
          least_power(power * share * frame.inverse_unit)};
}

Region half_space_in(const ListFrame& frame, const Point3& normal, double height) {
  const Point3& o = frame.origin;
  const double at = dot(normal, o);
  const double error =
      kDoubleError * (std::abs(height) + std::abs(o.x) + std::abs(o.y) + std::abs(o.z));
  return {static_cast<float>(normal.x / 2), static_cast<float>(normal.y / 2),
          static_cast<float>(normal.z / 2), 0,
          least_power((height - at - error) * frame.inverse_unit)};
}

void touching(const BallList& in, const NodeBounds& node, const ListFrame& frame, BallList& out) {
  static const Touching fastest = select();
  fastest(in, node, frame, out);
}

}  // namespace stream_recon
