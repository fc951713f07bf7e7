// The circumscribed balls of many tetrahedra, roughly but surely: what their facets see of them.
//
// Guarantees: estimates keep the promise of BallEstimate::kError or are NaN: for tetrahedra that
// are too flat or too uneven for doubles, and for coordinates outside the range where powers of
// lengths are safe. The bits do not depend on the processor; with AVX2 four tetrahedra cost little
// more than one. Thread rule: one estimator a thread. Memory: 5 KB. Cost: about 15 ns a
// tetrahedron. The error analysis is in docs/algorithms/gamma.md.
#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "spatial/ball_estimate.h"
#include "spatial/cell_view.h"

namespace stream_recon {

struct CellBall {
  std::array<float, 4> heights{};  ///< as facet i sees the centre, see BallEstimate
  double radius = 0;

  BallEstimate from(int side) const { return {heights[side], radius}; }
};

namespace detail {

/// Coordinates of tetrahedra, turned so that each step is a loop over the lanes.
struct BallLanes {
  static constexpr std::size_t kCount = 32;
  using Row = double[kCount];

  alignas(64) Row x[4], y[4], z[4];  ///< of the four vertices
  alignas(64) Row height[4];
  alignas(64) Row radius;
};

using BallKernel = void (*)(BallLanes& lanes);

/// The fastest variant that this processor has.
BallKernel select_ball_kernel();

/// The variants, each to be tested against the other.
void estimate_lanes_portable(BallLanes& lanes);
#if defined(__x86_64__)
void estimate_lanes_avx2(BallLanes& lanes);
#endif

}  // namespace detail

class BallEstimator {
 public:
  /// \pre `cells` is used in place: no insertion while this lives.
  explicit BallEstimator(const CellView& cells);

  /// results[i] becomes the ball of cells[i]. \pre live finite cells, results as long as cells
  void estimate(std::span<const CellId> cells, std::span<CellBall> results);

 private:
  void estimate_batch(std::span<const CellId> cells, std::span<CellBall> results);

  CellView cells_;
  detail::BallKernel kernel_;
  detail::BallLanes lanes_;
};

}  // namespace stream_recon
