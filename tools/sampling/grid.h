// A grid of numbers, read slice by slice: a volume on its way to points.
//
// Grids are chained: each takes what it needs from the one before it, so that memory is the few
// slices that each step holds. Slices are asked for in rising order; a second pass may begin at 0.
// Thread rule: one reader.
#pragma once

#include <array>
#include <cstddef>
#include <span>

namespace stream_recon {

using GridSize = std::array<std::size_t, 3>;  ///< along i, j, k

/// The cells from `low` up to, but without, `high`.
struct GridBox {
  GridSize low{};
  GridSize high{};

  std::size_t extent(std::size_t axis) const { return high[axis] - low[axis]; }
};

class Grid {
 public:
  virtual ~Grid() = default;

  virtual const GridSize& size() const = 0;

  /// Fills `out` (size[0] * size[1] values, i fastest) with slice k.
  /// \throw InputError truncated or damaged file
  virtual void read_slice(std::size_t k, std::span<double> out) = 0;

  std::size_t slice_cells() const { return size()[0] * size()[1]; }
};

}  // namespace stream_recon
