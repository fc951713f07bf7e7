// The sides of triangles in pairs of opposite directions.
//
// Side 3 t + i of triangle t goes from its corner i to the next. Guarantees: as many pairs at an
// edge as there can be; of an edge with more than two sides which pairs is left to `choose`, or to
// the order of the sides. Thread rule: pure. Memory: 16 bytes a side. Cost: n log n.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <limits>
#include <span>
#include <vector>

namespace stream_recon {

inline constexpr std::uint32_t kNoSide = std::numeric_limits<std::uint32_t>::max();

/// Of the same triangle.
inline std::uint32_t next_side(std::uint32_t side) {
  return side % 3 == 2 ? side - 2 : side + 1;
}

/// At an edge of two sides a direction: whether the first is to be paired with the second of the
/// other direction.
using CrossesPairs = std::function<bool(const std::array<std::uint32_t, 2>& up,
                                        const std::array<std::uint32_t, 2>& down)>;

/// \return of each side the opposite one, or kNoSide
std::vector<std::uint32_t> pair_sides(std::span<const std::array<std::uint32_t, 3>> triangles,
                                      const CrossesPairs& crosses = {});

}  // namespace stream_recon
