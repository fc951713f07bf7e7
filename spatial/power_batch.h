// Power tests of one site against four cells at once: the weighted twin of sphere_batch.h.
//
// Guarantees: as there, with the bounds of power_filter.h: a lane set in `inside` (`outside`) is
// certain, one set in `cospherical` is exactly orthogonal; a lane in none is for the exact
// predicates. A site is one vector register, so weights cost nothing to load.
// Thread rule: const.
#pragma once

#include <array>

#include "spatial/cell_array.h"
#include "spatial/point.h"
#include "spatial/sphere_batch.h"

namespace stream_recon::detail {

/// `exact_reach`: coordinate differences up to this make an in-sphere determinant exact.
using PowerBatchTest = SphereBatch (*)(const std::array<const Cell*, 4>& cells,
                                       const WeightedPoint3* sites, const WeightedPoint3& query,
                                       double exact_reach);

/// The fastest variant that this processor has.
PowerBatchTest select_power_batch_test();

/// The variants, each to be tested against the other.
SphereBatch test_powers_portable(const std::array<const Cell*, 4>& cells,
                                 const WeightedPoint3* sites, const WeightedPoint3& query,
                                 double exact_reach);
#if defined(__x86_64__)
SphereBatch test_powers_avx2(const std::array<const Cell*, 4>& cells, const WeightedPoint3* sites,
                             const WeightedPoint3& query, double exact_reach);
#endif

}  // namespace stream_recon::detail
