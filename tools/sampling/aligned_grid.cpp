#include "tools/sampling/aligned_grid.h"

#include <algorithm>
#include <cassert>
#include <limits>
#include <utility>

namespace stream_recon {

AlignedGrid::AlignedGrid(Grid& grid, std::vector<SliceShift> shifts)
    : grid_(grid), shifts_(std::move(shifts)), size_(grid.size()), slice_(grid.slice_cells()) {
  assert(shifts_.size() == size_[2]);
  SliceShift most;
  for (const SliceShift& shift : shifts_) {
    most = {std::max(most.i, shift.i), std::max(most.j, shift.j)};
  }
  size_[0] += most.i;
  size_[1] += most.j;
}

void AlignedGrid::read_slice(std::size_t k, std::span<double> out) {
  grid_.read_slice(k, slice_);
  std::fill(out.begin(), out.end(), std::numeric_limits<double>::quiet_NaN());
  const std::size_t width = grid_.size()[0];
  for (std::size_t j = 0; j < grid_.size()[1]; ++j) {
    std::copy_n(&slice_[j * width], width, &out[(j + shifts_[k].j) * size_[0] + shifts_[k].i]);
  }
}

}  // namespace stream_recon
