// How far inside the object a cell lies, smoothed: the boundary is where it is 1/2.
//
// Guarantees: a cell of the object has a value above 1/2, any other one below: an edge of the grid
// crosses the boundary iff it joins a cell of the object to one outside. So nothing thin is lost
// and nothing is joined or torn; smoothing decides only where on the edge the crossing is, never
// closer than a tenth of an edge to its ends.
// Memory: that of BlurredGrid. Thread rule: one reader.
// Source: in the spirit of constrained elastic surface nets (Gibson 1998, section 3), where each
// node of the surface stays in its cell.
#pragma once

#include "tools/sampling/blurred_grid.h"
#include "tools/sampling/mask_grid.h"

namespace stream_recon {

class SmoothedMask : public Grid {
 public:
  /// \pre the mask keeps at least blur_radius(sigma) + 2 slices
  /// \param sigma of the Gaussian, cells, > 0
  SmoothedMask(MaskGrid& mask, double sigma)
      : mask_(mask), blurred_(mask, sigma, BeyondEdge::kZero) {}

  const GridSize& size() const override { return mask_.size(); }
  void read_slice(std::size_t k, std::span<double> out) override;

 private:
  MaskGrid& mask_;
  BlurredGrid blurred_;
};

}  // namespace stream_recon
