// A stack whose slices are moved in their planes, by whole cells.
//
// Guarantees: no cell is lost, the grid grows; cells that no voxel comes to are NaN. What is left
// of an offset, at most half a cell, is for the points' positions (Placement): values are never
// mixed. Memory: one slice. Thread rule: one reader.
#pragma once

#include <vector>

#include "tools/sampling/grid.h"

namespace stream_recon {

/// Whole cells along i and j, each >= 0.
struct SliceShift {
  std::size_t i = 0;
  std::size_t j = 0;
};

class AlignedGrid : public Grid {
 public:
  /// \pre one shift a slice
  AlignedGrid(Grid& grid, std::vector<SliceShift> shifts);

  const GridSize& size() const override { return size_; }
  void read_slice(std::size_t k, std::span<double> out) override;

 private:
  Grid& grid_;
  std::vector<SliceShift> shifts_;
  GridSize size_;
  std::vector<double> slice_;
};

}  // namespace stream_recon
