// Where the points of an index node can be: a box and, for points near a surface, a disc.
//
// Guarantees: conservative in floating point. Every point p of the node has low <= p - origin <=
// high; with m the middle of that box, slab_low <= normal.(p - origin - m) <= slab_high, and p lies
// within `radius` of the line through m along `normal`. The disc is what makes huge balls cheap: a
// patch nearly tangent to such a ball fills the corner of its box, but not of its disc.
// Thread rule: values. Memory: 48 bytes a node.
// Source: bounding boxes as in R-trees (Guttman 1984; packed along the Hilbert curve: Kamel,
// Faloutsos 1994); the disc is ours (docs/algorithms/index.md).
#pragma once

#include <cstddef>
#include <span>
#include <type_traits>

#include "spatial/point.h"

namespace stream_recon {

struct NodeBounds {
  float low[3];
  float high[3];
  float normal[3];  ///< of unit length but for rounding; used as it stands
  float slab_low;
  float slab_high;
  float radius;

  /// No points: low > high.
  bool empty() const { return !(low[0] <= high[0]); }
};
static_assert(sizeof(NodeBounds) == 48 && std::is_trivially_copyable_v<NodeBounds>);

NodeBounds empty_bounds();

/// Of the box. \pre not empty
double squared_diagonal(const NodeBounds& bounds);

/// Bounds of points, given relative to a common origin. Cost: about 10 ns a point and 150 a node.
/// \param reach no coordinate of `points` and of their origin is larger, for the rounding of the
///        differences that they are
NodeBounds bounds_of_points(std::span<const Point3> points, double reach);

/// Bounds of what other nodes bound; empty ones are passed over. Looser than from the points.
NodeBounds bounds_of_nodes(std::span<const NodeBounds> nodes, double reach);

/// The numbers that tests of a node use, widened to doubles.
struct NodeFrame {
  explicit NodeFrame(const NodeBounds& bounds);

  Point3 low, high;
  Point3 middle;
  Point3 normal;
  double inverse_normal_squared;
  double slab_low, slab_high, radius;
};

}  // namespace stream_recon
