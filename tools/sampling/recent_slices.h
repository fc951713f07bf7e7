// The last slices of a grid, kept for several readers that walk side by side.
//
// Guarantees: a slice among the last `kept` taken is not read again.
// Memory: `kept` slices of doubles. Thread rule: one reader at a time.
#pragma once

#include <span>
#include <vector>

#include "tools/sampling/grid.h"

namespace stream_recon {

class RecentSlices {
 public:
  RecentSlices(Grid& source, std::size_t kept);

  const GridSize& size() const { return source_.size(); }

  /// Slice k, i fastest; the view holds until `kept` other slices were asked for.
  /// \throw what the grid throws
  std::span<const double> slice(std::size_t k);

 private:
  struct Slice {
    std::size_t k = static_cast<std::size_t>(-1);
    std::vector<double> cells;
  };

  Grid& source_;
  std::vector<Slice> kept_;  ///< slice k at k modulo their number
};

}  // namespace stream_recon
