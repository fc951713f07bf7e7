// Many balls and half-spaces against one index node at once.
//
// Guarantees: touching() keeps every region that may hold a point of the node, by bounds that are
// conservative in floating point; the answer is the same on every processor.
// Thread rule: values. Memory: 24 bytes a region. Cost: about 2 ns a region and node with AVX2.
//
// A region is where  lift |v|^2 - 2 c.v + power <= 0  with v = (p - origin) / unit, divided by what
// makes |c| and lift at most 1. Near the surface of a huge ball the terms are as small as v, so
// that floats tell as much as doubles would of centre and radius.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "spatial/node_bounds.h"

namespace stream_recon {

/// Where the regions of a list are described. Points are relative to the origin of the bounds.
struct ListFrame {
  Point3 origin;
  double unit;  ///< no point asked about is farther away from origin
  double inverse_unit;

  /// For all points that a node bounds. \pre not empty
  explicit ListFrame(const NodeBounds& bounds);
};

struct Region {
  float x, y, z;  ///< c
  float lift;
  float power;
};

/// \param centre, squared_radius within which rounding has been allowed for
Region ball_in(const ListFrame& frame, const Point3& centre, double squared_radius);
/// Of the points p with normal.p >= height. \param normal of unit length
Region half_space_in(const ListFrame& frame, const Point3& normal, double height);

/// Structure of arrays, so that vector instructions apply.
struct BallList {
  static constexpr std::size_t kMost = 512;
  static constexpr std::size_t kLanes = 8;

  std::size_t count = 0;
  alignas(32) std::array<float, kMost + kLanes> x, y, z, lift, power;
  alignas(32) std::array<std::uint32_t, kMost + kLanes> id;  ///< of the caller

  void push(const Region& region, std::uint32_t which) {
    x[count] = region.x;
    y[count] = region.y;
    z[count] = region.z;
    lift[count] = region.lift;
    power[count] = region.power;
    id[count++] = which;
  }
};

/// Replaces `out` by the regions of `in` that may hold a point of the node. \pre its points are
/// within the unit of the frame that `in` is described in
void touching(const BallList& in, const NodeBounds& node, const ListFrame& frame, BallList& out);

namespace detail {

/// The variants, each to be tested against the other.
void touching_portable(const BallList& in, const NodeBounds& node, const ListFrame& frame,
                       BallList& out);
#if defined(__x86_64__)
void touching_avx2(const BallList& in, const NodeBounds& node, const ListFrame& frame,
                   BallList& out);
#endif

}  // namespace detail

}  // namespace stream_recon
