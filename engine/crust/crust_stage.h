// The power diagram of the labelled poles: the crust, as a surface over a point store of its own,
// and the power shape.
//
// Guarantees and memory as of crust/crust_windows.h, crust/crust_assembly.h and
// shape/shape_store.h, which it calls.
// What an earlier, interrupted run left of it is removed first. Thread rule: one caller.
#pragma once

#include "engine/crust/crust_assembly.h"
#include "engine/crust/crust_windows.h"
#include "engine/order/ingest.h"
#include "engine/stage_context.h"

namespace stream_recon {

struct CrustStageOptions {
  unsigned threads = 1;
  std::uint64_t window_points =
      0;  ///< samples of a window at most; 0: as many as the memory allows
  std::uint64_t chunk_points = 1;
  bool has_crust = true;
  bool has_shape = false;
};

struct CrustSurface {
  CrustFacts facts;  ///< without a crust all 0
  PowerTotals power;
  ShapeCounts shape;  ///< without a power shape all 0
};

/// \pre The pole store is in the scratch directory, and `cloud` has far points.
/// \throw BudgetError, IoError, InputError, Interrupted
CrustSurface build_crust(const CloudSummary& cloud, std::uint64_t point_count,
                         const CrustStageOptions& options, const StageContext& context);

}  // namespace stream_recon
