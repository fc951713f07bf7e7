#include "tools/sampling/recent_slices.h"

namespace stream_recon {

RecentSlices::RecentSlices(Grid& source, std::size_t kept) : source_(source), kept_(kept) {
  for (Slice& slice : kept_) slice.cells.resize(source.slice_cells());
}

std::span<const double> RecentSlices::slice(std::size_t k) {
  Slice& slice = kept_[k % kept_.size()];
  if (slice.k != k) {
    slice.k = static_cast<std::size_t>(-1);
    source_.read_slice(k, slice.cells);
    slice.k = k;
  }
  return slice.cells;
}

}  // namespace stream_recon
