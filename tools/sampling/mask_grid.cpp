#include "tools/sampling/mask_grid.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace stream_recon {
namespace {

constexpr auto kNone = static_cast<std::size_t>(-1);

}  // namespace

MaskGrid::MaskGrid(RecentSlices& source, VoxelSelection selection, const GridBox& box,
                   std::size_t kept)
    : source_(source), selection_(std::move(selection)), box_(box), kept_k_(kept, kNone) {
  for (std::size_t axis = 0; axis < 3; ++axis) size_[axis] = box.extent(axis) + 2;
  kept_.assign(kept, std::vector<std::uint8_t>(slice_cells()));
}

std::span<const std::uint8_t> MaskGrid::slice(std::size_t k) {
  const std::size_t at = k % kept_.size();
  if (kept_k_[at] != k) {
    kept_k_[at] = kNone;
    take_slice(k, kept_[at]);
    kept_k_[at] = k;
  }
  return kept_[at];
}

void MaskGrid::take_slice(std::size_t k, std::span<std::uint8_t> out) {
  std::fill(out.begin(), out.end(), std::uint8_t{0});
  if (k == 0) cells_inside_ = 0;
  if (k == 0 || k + 1 == size_[2]) return;
  const std::span<const double> voxels = source_.slice(box_.low[2] + k - 1);
  const std::size_t width = box_.extent(0);
  for (std::size_t j = 0; j < box_.extent(1); ++j) {
    const auto inside = out.subspan((j + 1) * size_[0] + 1, width);
    const std::size_t from = (box_.low[1] + j) * source_.size()[0] + box_.low[0];
    selection_.mark(voxels.subspan(from, width), inside);
  }
  cells_inside_ = std::accumulate(out.begin(), out.end(), cells_inside_);
}

void MaskGrid::read_slice(std::size_t k, std::span<double> out) {
  const auto inside = slice(k);
  std::copy(inside.begin(), inside.end(), out.begin());
}

}  // namespace stream_recon
