// The object as a grid of 1 and 0, with one layer of cells outside it all around.
//
// Guarantees: the outermost cells on every side are 0, so what lies at the volume's edge is closed
// there. Cell (0, 0, 0) is cell box.low - (1, 1, 1) of the source.
// Memory: the last `kept` slices at 1 byte a cell.
// Thread rule: one reader.
#pragma once

#include <cstdint>
#include <vector>

#include "tools/sampling/grid.h"
#include "tools/sampling/recent_slices.h"
#include "tools/sampling/voxel_selection.h"

namespace stream_recon {

class MaskGrid : public Grid {
 public:
  /// \param box the part of `source` that may hold the object
  /// \param kept slices that can be asked for again, >= 1
  MaskGrid(RecentSlices& source, VoxelSelection selection, const GridBox& box, std::size_t kept);

  const GridSize& size() const override { return size_; }
  void read_slice(std::size_t k, std::span<double> out) override;

  /// Slice k, 1 byte a cell; the view holds until `kept` later slices were asked for.
  std::span<const std::uint8_t> slice(std::size_t k);

  /// Cells of the object in the slices of this pass.
  std::uint64_t cells_inside() const { return cells_inside_; }

 private:
  void take_slice(std::size_t k, std::span<std::uint8_t> out);

  RecentSlices& source_;
  VoxelSelection selection_;
  GridBox box_;
  GridSize size_{};
  std::vector<std::vector<std::uint8_t>> kept_;  ///< slice k at k modulo their number
  std::vector<std::size_t> kept_k_;
  std::uint64_t cells_inside_ = 0;
};

}  // namespace stream_recon
