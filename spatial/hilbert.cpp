#include "spatial/hilbert.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace stream_recon {
namespace {

constexpr int kLevelsPerStep = 3;
constexpr int kStepBits = 3 * kLevelsPerStep;
constexpr std::uint32_t kStepMask = (1U << kStepBits) - 1;
constexpr std::uint32_t kStates = 12;
static_assert(HilbertCurve::kBits % kLevelsPerStep == 0);

// The curve in a cell is the Gray code of its octants, turned by a state: the octant where it
// enters (always one of 0, 3, 5, 6) and the axis (0 to 2) between entry and exit.
struct State {
  std::uint32_t entry;
  std::uint32_t axis;

  constexpr std::uint32_t number() const { return (entry >> 1) * 3 + axis; }
  static constexpr State of(std::uint32_t number) {
    constexpr std::uint32_t kEntries[] = {0, 3, 5, 6};
    return {kEntries[number / 3], number % 3};
  }
};

constexpr std::uint32_t gray_code(std::uint32_t i) {
  return i ^ (i >> 1);
}
constexpr std::uint32_t inverse_gray_code(std::uint32_t g) {
  return g ^ (g >> 1) ^ (g >> 2);
}
constexpr std::uint32_t rotate_left(std::uint32_t octant, std::uint32_t by) {
  return ((octant << by) | (octant >> (3 - by))) & 7;
}
constexpr std::uint32_t rotate_right(std::uint32_t octant, std::uint32_t by) {
  return ((octant >> by) | (octant << (3 - by))) & 7;
}

// Where the curve enters the i-th octant, and along which axis it leaves it, in state {0, 0}.
constexpr std::uint32_t entry_of(std::uint32_t i) {
  return i == 0 ? 0 : gray_code((i - 1) / 2 * 2);
}
constexpr std::uint32_t axis_of(std::uint32_t i) {
  constexpr std::uint32_t kAxes[] = {0, 1, 1, 2, 2, 1, 1, 0};
  return kAxes[i];
}

// Enters an octant: its place on the curve, and the state inside it.
constexpr std::uint32_t descend(State& state, std::uint32_t octant) {
  const std::uint32_t turn = (state.axis + 1) % 3;
  const std::uint32_t place = inverse_gray_code(rotate_right(octant ^ state.entry, turn));
  state.entry ^= rotate_left(entry_of(place), turn);
  state.axis = (state.axis + axis_of(place) + 1) % 3;
  return place;
}

// For a state and three levels of octants: the next state above three levels of places.
constexpr std::array<std::uint16_t, kStates << kStepBits> make_steps() {
  std::array<std::uint16_t, kStates << kStepBits> steps{};
  for (std::uint32_t i = 0; i < steps.size(); ++i) {
    State state = State::of(i >> kStepBits);
    std::uint32_t places = 0;
    for (int level = kLevelsPerStep - 1; level >= 0; --level) {
      places = places << 3 | descend(state, (i >> (3 * level)) & 7);
    }
    steps[i] = static_cast<std::uint16_t>(state.number() << kStepBits | places);
  }
  return steps;
}

constexpr auto kSteps = make_steps();

// Puts two zero bits between the low 21 bits of n.
std::uint64_t spread(std::uint64_t n) {
  n = (n | n << 32) & 0x001f00000000ffffU;
  n = (n | n << 16) & 0x001f0000ff0000ffU;
  n = (n | n << 8) & 0x100f00f00f00f00fU;
  n = (n | n << 4) & 0x10c30c30c30c30c3U;
  return (n | n << 2) & 0x1249249249249249U;
}

std::uint64_t grid_coordinate(double offset) {
  constexpr double kLast = (1 << HilbertCurve::kBits) - 1;
  return static_cast<std::uint64_t>(std::min(std::max(0.0, offset), kLast));
}

double choose_prescale(const Box3& box) {
  const double extent = box.extent();
  if (extent >= 0x1p1000) return 0x1p-30;
  if (extent < 0x1p-900) return 0x1p100;
  return 1;
}

}  // namespace

HilbertCurve::HilbertCurve(const Box3& box)
    : prescale_(choose_prescale(box)),
      low_{box.low.x * prescale_, box.low.y * prescale_, box.low.z * prescale_},
      cells_per_unit_(0) {
  if (box.empty()) {
    low_ = {};
    return;
  }
  const double extent = std::max({box.high.x * prescale_ - low_.x, box.high.y * prescale_ - low_.y,
                                  box.high.z * prescale_ - low_.z});
  if (extent > 0) cells_per_unit_ = std::ldexp(1.0, kBits) / extent;
}

std::uint64_t HilbertCurve::key(const Point3& p) const {
  const std::uint64_t x = grid_coordinate((p.x * prescale_ - low_.x) * cells_per_unit_);
  const std::uint64_t y = grid_coordinate((p.y * prescale_ - low_.y) * cells_per_unit_);
  const std::uint64_t z = grid_coordinate((p.z * prescale_ - low_.z) * cells_per_unit_);
  const std::uint64_t octants = spread(x) | spread(y) << 1 | spread(z) << 2;
  std::uint64_t key = 0;
  std::uint32_t step = 0;
  for (int shift = 3 * kBits - kStepBits; shift >= 0; shift -= kStepBits) {
    const auto next = static_cast<std::uint32_t>(octants >> shift) & kStepMask;
    step = kSteps[(step & ~kStepMask) | next];
    key = key << kStepBits | (step & kStepMask);
  }
  return key;
}

}  // namespace stream_recon
