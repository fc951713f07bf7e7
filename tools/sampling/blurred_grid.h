// A grid smoothed with a Gaussian, while its slices go by.
//
// Guarantees: the same bytes on every machine for the same grid. kIgnored: only cells that are
// finite take part, what lies beyond the edge does not; a cell that is not finite stays so. kZero:
// beyond the edge everything is 0; cells must be finite.
// Memory: 2 r + 1 slices of floats (twice that for kIgnored), r = ceil(3 sigma), and four
// slices of work. Cost: about 3 (2 r + 1) multiplications a cell. Thread rule: one reader.
// Source: separable Gaussian filtering; for kIgnored normalized convolution (Knutsson,
// Westin 1993).
#pragma once

#include <cstddef>
#include <vector>

#include "tools/sampling/grid.h"

namespace stream_recon {

enum class BeyondEdge { kIgnored, kZero };

/// Slices ahead of (and behind) a slice that its smoothing looks at; sigma in cells.
std::size_t blur_radius(double sigma);

class BlurredGrid : public Grid {
 public:
  /// \pre 0 < sigma (cells)
  BlurredGrid(Grid& source, double sigma, BeyondEdge beyond);

  const GridSize& size() const override { return source_.size(); }
  void read_slice(std::size_t k, std::span<double> out) override;

 private:
  /// A slice smoothed in its plane.
  struct Plane {
    std::size_t k = static_cast<std::size_t>(-1);
    std::vector<float> sum;
    std::vector<float> weight;  ///< of the cells that took part; kIgnored only
    std::vector<bool> known;
  };

  Plane& plane(std::size_t k);
  void fill(Plane& plane, std::size_t k);
  void blur_in_plane(std::vector<float>& cells);
  void add_planes(std::size_t k, std::vector<float> Plane::*part, std::vector<float>& total);

  Grid& source_;
  BeyondEdge beyond_;
  std::size_t radius_;
  std::vector<float> kernel_;  ///< 2 radius + 1 weights, sum 1
  std::vector<Plane> planes_;  ///< slice k at k modulo their number
  std::vector<double> slice_;
  std::vector<float> rows_, total_, total_weight_;
};

}  // namespace stream_recon
