#include "tools/sampling/smoothed_mask.h"

#include <algorithm>

namespace stream_recon {
namespace {

constexpr double kBoundary = 0.5;
// A cell at the end of an edge of length 1 whose other end has at most the value 1, or at least 0,
// is then a tenth of the edge or more away from the crossing.
constexpr double kLeastDifference = 1.0 / 16;

}  // namespace

void SmoothedMask::read_slice(std::size_t k, std::span<double> out) {
  blurred_.read_slice(k, out);
  const auto inside = mask_.slice(k);
  for (std::size_t at = 0; at < out.size(); ++at) {
    out[at] = inside[at] != 0 ? std::max(out[at], kBoundary + kLeastDifference)
                              : std::min(out[at], kBoundary - kLeastDifference);
  }
}

}  // namespace stream_recon
