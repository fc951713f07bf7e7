// In-sphere tests of one point against four cells at once.
//
// Guarantees: a lane set in `inside` (`outside`) is certain, one set in `cospherical` is exactly
// zero; a lane in none is for the exact predicates. The bounds are those of predicates_filter.h, so
// that the answer is the same on every processor; with AVX2 the four tests cost little more than
// one. Lanes of infinite cells are meaningless.
// Thread rule: const.
#pragma once

#include <array>
#include <cstdint>

#include "spatial/cell_array.h"
#include "spatial/point.h"

namespace stream_recon::detail {

/// Bit i belongs to lane i.
struct SphereBatch {
  unsigned inside;
  unsigned outside;
  unsigned cospherical;
};

/// A point that vector instructions can load whole.
struct alignas(32) PaddedPoint {
  Point3 point;
  double padding = 0;
};

/// `exact_reach`: coordinate differences up to this make a determinant of doubles exact.
using SphereBatchTest = SphereBatch (*)(const std::array<const Cell*, 4>& cells,
                                        const Point3* points, const PaddedPoint& query,
                                        double exact_reach);

/// The fastest variant that this processor has.
SphereBatchTest select_sphere_batch_test();

/// The variants, each to be tested against the other.
SphereBatch test_spheres_portable(const std::array<const Cell*, 4>& cells, const Point3* points,
                                  const PaddedPoint& query, double exact_reach);
#if defined(__x86_64__)
SphereBatch test_spheres_avx2(const std::array<const Cell*, 4>& cells, const Point3* points,
                              const PaddedPoint& query, double exact_reach);
#endif

}  // namespace stream_recon::detail
