#include "tools/sampling/smoothed_mask.h"

#include <algorithm>

namespace stream_recon {
namespace {

constexpr double kBoundary = 0.5;
// A cell at the end of an edge of length 1 whose other end has at most the value 1, or at least 0,
// is then a tenth of the edge or more away from the crossing.
constexpr double kLeastDifference = 1.0 / 16;

void hold_to(std::span<const std::uint8_t> inside, std::span<double> values) {
  for (std::size_t at = 0; at < values.size(); ++at) {
    values[at] = inside[at] != 0 ? std::max(values[at], kBoundary + kLeastDifference)
                                 : std::min(values[at], kBoundary - kLeastDifference);
  }
}

}  // namespace

void SmoothedMask::read_slice(std::size_t k, std::span<double> out) {
  blurred_.read_slice(k, out);
  const auto inside = mask_.slice(k);
  if (smoothing_.keep_thin) return hold_to(inside, out);
  if (k == 0) cells_lost_ = cells_gained_ = 0;
  for (std::size_t at = 0; at < out.size(); ++at) {
    const bool is_inside = out[at] >= kBoundary;
    cells_lost_ += inside[at] != 0 && !is_inside ? 1 : 0;
    cells_gained_ += inside[at] == 0 && is_inside ? 1 : 0;
  }
}

}  // namespace stream_recon
