// From the solid's facets beyond the gamma shape to patches that close its holes.
//
// Guarantees: patches are functions of the cloud alone; none adds a vertex, and the border of each
// is the hole's. A hole that cannot be closed is left open, or filled as the solid is, and counted.
// What an earlier, interrupted run left is removed first. Thread rule: one caller; patches side by
// side. Memory: as hybrid/hole_search.h and hybrid/hole_crust.h; then some holes at a time, about
// 500 bytes a triangle of the crust near them. Source: docs/algorithms/hybrid.md
#pragma once

#include <cstdint>

#include "engine/crust/crust_windows.h"
#include "engine/order/ingest.h"
#include "engine/report.h"
#include "engine/stage_context.h"
#include "engine/surface/facet_export.h"

namespace stream_recon {

struct HybridStageOptions {
  unsigned threads = 1;
  std::uint64_t window_points = 0;  ///< samples of a window at most; 0: what the memory allows
  ChunkLayout layout;
  bool fills_rest = false;  ///< holes without a patch get the solid's triangles
};

struct HybridResult {
  HybridReport report;
  PowerTotals power;
};

/// Adds to the exports under kLabelledPrefix.
/// \pre label_facets() has set the fills apart; the point store and the pole store are in the
/// scratch directory, and `cloud` has far points.
/// \throw IoError, BudgetError, InputError, Interrupted
HybridResult build_hybrid(const CloudSummary& cloud, const HybridStageOptions& options,
                          const StageContext& context);

}  // namespace stream_recon
