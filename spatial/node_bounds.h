// Where the points of an index node can be: a box and, for points near a surface, a curved patch.
//
// Guarantees: conservative in floating point. Every point p of the node has low <= p - origin <=
// high, and numbers u, w and t with |u| <= extent[0], |w| <= extent[1], thick_low <= t <=
// thick_high:
//   p - origin = middle + u rows[0] + w rows[1] + (t + (curvature[0] u^2 + curvature[1] w^2) / 2)
//   normal
// The patch is what makes huge balls cheap: points of a surface nearly tangent to such a ball
// leave free the corner of their box, and of a flat slab around them, that the ball fills.
// Thread rule: values. Memory: 96 bytes a node.
// Source: bounding boxes as in R-trees (Guttman 1984; packed along the Hilbert curve: Kamel,
// Faloutsos 1994); the patch is ours (docs/algorithms/index.md).
#pragma once

#include <cstddef>
#include <span>
#include <type_traits>

#include "spatial/point.h"

namespace stream_recon {

struct NodeBounds {
  /// The normal and, but for multiples of it, the rows have unit length and right angles to this;
  /// the multiples are smaller than 1, and so is curvature times extent.
  static constexpr double kAxesError = 0x1p-21;

  float low[3];
  float high[3];
  float middle[3];
  float normal[3];
  float rows[2][3];
  float curvature[2];
  float extent[2];
  float thick_low;
  float thick_high;

  /// No points: low > high.
  bool empty() const { return !(low[0] <= high[0]); }
};
static_assert(sizeof(NodeBounds) == 96 && std::is_trivially_copyable_v<NodeBounds>);

NodeBounds empty_bounds();

/// Of the box. \pre not empty
double squared_diagonal(const NodeBounds& bounds);

/// Bounds of points, given relative to a common origin. Cost: about 40 ns a point and 500 a node.
/// \param reach no coordinate of `points` and of their origin is larger, for the rounding of the
///        differences that they are
NodeBounds bounds_of_points(std::span<const Point3> points, double reach);

/// Bounds of what other nodes bound; empty ones are passed over. Looser than from the points.
NodeBounds bounds_of_nodes(std::span<const NodeBounds> nodes, double reach);

}  // namespace stream_recon
