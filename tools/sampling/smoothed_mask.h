// How far inside the object a cell lies, smoothed: the boundary is where it is 1/2.
//
// Guarantees: with keep_thin a cell of the object has a value above 1/2, any other one below: an
// edge of the grid crosses the boundary iff it joins a cell of the object to one outside, not
// closer than a tenth of it to its ends. So nothing thin is lost and nothing joined or torn.
// Without it what is thinner than about 1.35 sigma is smoothed away, and counted.
// Memory: that of BlurredGrid. Thread rule: one reader.
// Source: keep_thin is in the spirit of constrained elastic surface nets (Gibson 1998, section 3),
// where each node of the surface stays in its cell.
#pragma once

#include <cstdint>

#include "tools/sampling/blurred_grid.h"
#include "tools/sampling/mask_grid.h"

namespace stream_recon {

struct MaskSmoothing {
  double sigma = 0;        ///< of the Gaussian, cells, >= 0; 0: none
  bool keep_thin = false;  ///< the object's cells stay inside, all others outside
};

class SmoothedMask : public Grid {
 public:
  /// \pre the mask keeps at least blur_radius(sigma) + 2 slices; sigma > 0
  SmoothedMask(MaskGrid& mask, const MaskSmoothing& smoothing)
      : mask_(mask), smoothing_(smoothing), blurred_(mask, smoothing.sigma, BeyondEdge::kZero) {}

  const GridSize& size() const override { return mask_.size(); }
  void read_slice(std::size_t k, std::span<double> out) override;

  /// Cells of the object, and others, that smoothing put on the other side, in this pass.
  std::uint64_t cells_lost() const { return cells_lost_; }
  std::uint64_t cells_gained() const { return cells_gained_; }

 private:
  MaskGrid& mask_;
  MaskSmoothing smoothing_;
  BlurredGrid blurred_;
  std::uint64_t cells_lost_ = 0;
  std::uint64_t cells_gained_ = 0;
};

}  // namespace stream_recon
