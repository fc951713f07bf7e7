// The attraction that fits a patch of a surface to the points it must pass through.
//
//   p += rate / n * sum over i of (|d_i - d_min| + 1)^-16 * (b_i - p)
//
// with d_i the distance of p from the attracting point b_i, d_min the least of them: nearly all of
// the pull comes from the nearest points, and a place as far from several goes between them.
// Guarantees: the same bits for the same numbers: only sums, products, quotients and roots. Thread
// rule: pure. Cost: 10 ns an attracting point and step.
// Source: thesis, Computational Geometry and Surface Reconstruction from Unorganized Point Clouds,
// 2007, chapter 6. Lengths in the power are of voxels there, and in `unit` here.
#pragma once

#include <span>

#include "spatial/point.h"

namespace stream_recon {

struct AttractionOptions {
  double rate = 0.5;  ///< a, in (0, 1]
  double unit = 1;    ///< what counts as a difference of 1; positive
  int most_steps = 10;
  double still = 0.01;  ///< a step shorter than this, in units, is the last
};

struct Attracted {
  Point3 place;
  bool is_still = false;  ///< ended by `still`
};

/// One step.
Point3 attracted_once(const Point3& place, std::span<const Point3> points,
                      const AttractionOptions& options);

/// Steps until it moves little. Without points the place stays.
Attracted attracted(const Point3& place, std::span<const Point3> points,
                    const AttractionOptions& options);

}  // namespace stream_recon
