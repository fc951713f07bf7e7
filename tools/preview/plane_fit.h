// The direction of a surface that is seen only as depths: the least-squares plane around a cell.
//
// Depths much nearer or farther than the cell's own belong to something else and count little.
// Thread rule: const. Cost: some hundred depth look-ups a cell.
#pragma once

#include <cstddef>

#include "tools/preview/depth_buffer.h"

namespace stream_recon {

class Cells;

class PlaneFit {
 public:
  /// \pre The cells outlive it.
  explicit PlaneFit(const Cells& cells);

  /// Unit length, towards the viewer. \pre The cell is not empty.
  Vector3f normal(std::size_t x, std::size_t y) const;

 private:
  const Cells& cells_;
  std::ptrdiff_t radius_;  ///< of the window, cells
};

}  // namespace stream_recon
