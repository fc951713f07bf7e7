#include "spatial/nearest_list.h"

#include <algorithm>
#include <bit>
#include <limits>

namespace stream_recon {
namespace {

constexpr std::size_t kBlock = NearestList::kBlock;
constexpr std::size_t kMostSorted = 64;

using Keys = std::array<std::int32_t, kMostSorted>;

[[gnu::always_inline]] inline void squares_by_loop(const Point3& place, const PointColumns& points,
                                                   SquaredGaps& out) {
  for (std::size_t i = 0; i < kBlock; ++i) {
    const double dx = points.x[i] - place.x;
    const double dy = points.y[i] - place.y;
    const double dz = points.z[i] - place.z;
    out[i] = dx * dx + dy * dy + dz * dz;
  }
}

double gap(double place, double low, double high) {
  const double below = low - place;
  const double above = place - high;
  const double most = below > above ? below : above;
  return most > 0 ? most : 0;
}

[[gnu::always_inline]] inline void gaps_by_loop(const PointColumns& places, const NodeBounds& b,
                                                SquaredGaps& out) {
  for (std::size_t i = 0; i < kBlock; ++i) {
    const double dx = gap(places.x[i], b.low[0], b.high[0]);
    const double dy = gap(places.y[i], b.low[1], b.high[1]);
    const double dz = gap(places.z[i], b.low[2], b.high[2]);
    out[i] = dx * dx + dy * dy + dz * dz;
  }
}

/// The number of keys below each of the first ones. \pre All of the first kSize are set.
template <std::size_t kSize>
[[gnu::always_inline]] inline void places_among(const Keys& keys, std::size_t count, Keys& out) {
  for (std::size_t i = 0; i < count; ++i) {
    const std::int32_t key = keys[i];
    std::int32_t below = 0;
    for (std::size_t j = 0; j < kSize; ++j) below += keys[j] < key ? 1 : 0;
    out[i] = below;
  }
}

[[gnu::always_inline]] inline void places_by_loop(const Keys& keys, std::size_t count, Keys& out) {
  if (count <= 32) return places_among<32>(keys, count, out);
  if (count <= 48) return places_among<48>(keys, count, out);
  places_among<kMostSorted>(keys, count, out);
}

struct Loops {
  void (*squares)(const Point3&, const PointColumns&, SquaredGaps&);
  void (*gaps)(const PointColumns&, const NodeBounds&, SquaredGaps&);
  void (*places)(const Keys&, std::size_t, Keys&);
};

void squares_portable(const Point3& place, const PointColumns& points, SquaredGaps& out) {
  squares_by_loop(place, points, out);
}
void gaps_portable(const PointColumns& places, const NodeBounds& bounds, SquaredGaps& out) {
  gaps_by_loop(places, bounds, out);
}
void places_portable(const Keys& keys, std::size_t count, Keys& out) {
  places_by_loop(keys, count, out);
}

#if defined(__x86_64__)
__attribute__((target("avx2"))) void squares_avx2(const Point3& place, const PointColumns& points,
                                                  SquaredGaps& out) {
  squares_by_loop(place, points, out);
}
__attribute__((target("avx2"))) void gaps_avx2(const PointColumns& places, const NodeBounds& bounds,
                                               SquaredGaps& out) {
  gaps_by_loop(places, bounds, out);
}
__attribute__((target("avx2"))) void places_avx2(const Keys& keys, std::size_t count, Keys& out) {
  places_by_loop(keys, count, out);
}
#endif

Loops select() {
#if defined(__x86_64__)
  if (__builtin_cpu_supports("avx2")) return {squares_avx2, gaps_avx2, places_avx2};
#endif
  return {squares_portable, gaps_portable, places_portable};
}

const Loops kLoops = select();

/// The upper half of a double, which ascends with its value, but for the last bits, which the
/// number takes to make keys distinct.
std::int32_t key_of(double value, std::size_t number) {
  constexpr std::int32_t kNumberBits = kMostSorted - 1;
  const auto upper = static_cast<std::int32_t>(std::bit_cast<std::uint64_t>(value) >> 32);
  return (upper & ~kNumberBits) | static_cast<std::int32_t>(number);
}

/// A value's key is above that of another if it is this many times larger.
constexpr double kTold = 1 + 0x1p-13;

}  // namespace

void NearestList::offer(const PointColumns& points, std::uint64_t first_rank) {
  SquaredGaps squares;
  kLoops.squares(place_, points, squares);
  std::size_t count = count_;
  for (std::size_t i = 0; i < kBlock; ++i) {
    squares_[count] = squares[i];
    ranks_[count] = first_rank + i;
    count += squares[i] <= bound_ ? 1 : 0;
  }
  count_ = count;
  if (count_ > kRoom - kBlock) prune();
}

void NearestList::prune() {
  std::array<NearPoint, kMost> nearest;
  count_ = sorted(nearest);
  for (std::size_t i = 0; i < count_; ++i) {
    squares_[i] = nearest[i].squared_distance;
    ranks_[i] = nearest[i].rank;
  }
  bound_ = squares_[count_ - 1];
}

// Each goes where the number of smaller keys says; those whose keys do not tell their order are
// close together then, and few steps are left.
std::size_t NearestList::sorted(std::array<NearPoint, kMost>& out) const {
  Keys keys;
  Keys places;
  keys.fill(std::numeric_limits<std::int32_t>::max());
  for (std::size_t i = 0; i < count_; ++i) keys[i] = key_of(squares_[i], i);
  kLoops.places(keys, count_, places);
  std::array<std::uint8_t, kRoom> order;
  for (std::size_t i = 0; i < count_; ++i) order[places[i]] = static_cast<std::uint8_t>(i);

  std::size_t size = 0;
  for (std::size_t i = 0; i < count_; ++i) {
    const NearPoint point{squares_[order[i]], ranks_[order[i]]};
    if (size == kMost && !(point < out[kMost - 1])) {
      if (point.squared_distance > kTold * out[kMost - 1].squared_distance) break;
      continue;
    }
    std::size_t at = size == kMost ? kMost - 1 : size++;
    for (; at > 0 && point < out[at - 1]; --at) out[at] = out[at - 1];
    out[at] = point;
  }
  return size;
}

// The boxes are wider than their points by more than the roundings of a difference of coordinates:
// a gap is at most the difference it stands for. As both are squared and added in the same order, a
// squared gap is at most the squared distance that a list computes: nothing need be added to it.
void squared_gaps(const PointColumns& places, const NodeBounds& bounds, SquaredGaps& out) {
  kLoops.gaps(places, bounds, out);
}

}  // namespace stream_recon
