#include "engine/hybrid/side_pairs.h"

#include <algorithm>
#include <cstddef>
#include <tuple>

namespace stream_recon {
namespace {

struct Side {
  std::uint32_t low = 0, high = 0;  ///< corners
  std::uint32_t is_down = 0;        ///< from high to low
  std::uint32_t number = 0;

  friend bool operator<(const Side& a, const Side& b) {
    return std::tie(a.low, a.high, a.is_down, a.number) <
           std::tie(b.low, b.high, b.is_down, b.number);
  }
};

}  // namespace

std::vector<std::uint32_t> pair_sides(std::span<const std::array<std::uint32_t, 3>> triangles,
                                      const CrossesPairs& crosses) {
  std::vector<Side> sides;
  sides.reserve(3 * triangles.size());
  for (const auto& corners : triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t from = corners[i];
      const std::uint32_t to = corners[(i + 1) % 3];
      const auto number = static_cast<std::uint32_t>(sides.size());
      sides.push_back({std::min(from, to), std::max(from, to), from > to ? 1U : 0U, number});
    }
  }
  std::sort(sides.begin(), sides.end());
  std::vector<std::uint32_t> opposite(sides.size(), kNoSide);
  for (std::size_t up = 0; up < sides.size();) {
    std::size_t end = up;
    while (end < sides.size() && sides[end].low == sides[up].low &&
           sides[end].high == sides[up].high)
      ++end;
    std::size_t down = up;
    while (down < end && sides[down].is_down == 0) ++down;
    std::array<std::size_t, 2> turn{0, 1};
    if (crosses && down - up == 2 && end - down == 2 &&
        crosses({sides[up].number, sides[up + 1].number},
                {sides[down].number, sides[down + 1].number})) {
      turn = {1, 0};
    }
    const std::size_t pairs = std::min(down - up, end - down);
    for (std::size_t i = 0; i < pairs; ++i) {
      const std::uint32_t one = sides[up + i].number;
      const std::uint32_t two = sides[down + (pairs == 2 ? turn[i] : i)].number;
      opposite[one] = two;
      opposite[two] = one;
    }
    up = end;
  }
  return opposite;
}

}  // namespace stream_recon
