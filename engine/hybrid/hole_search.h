// The holes of the gamma shape: the solid's fills, put together where they share an edge.
//
// Guarantees: the fills of each hole stand one after the other, holes by their lowest fill, fills
// by their ranks; so do the samples of each hole: both are functions of the fills alone. Where four
// fills share an edge, all are of one hole. Thread rule: one caller; sorts on all threads. Memory,
// from the budget: 4 bytes a fill, and sorts of 32 bytes a fill and of 12 an edge of one side by
// side, or as much as there is. Source: Tarjan, Efficiency of a good but not linear set union
// algorithm, 1975.
#pragma once

#include <cstdint>

#include "engine/stage_context.h"

namespace stream_recon {

/// Names of the files of HoleFill and HolePoint in the scratch directory.
inline constexpr const char* kHoleFills = "hole_fills";
inline constexpr const char* kHolePoints = "hole_points";

struct HoleCounts {
  std::uint64_t holes = 0;
  std::uint64_t fills = 0;
};

/// From the files that label_facets() set apart, which are removed.
/// \pre The point store is in the scratch directory.
/// \throw IoError, BudgetError, Interrupted; InputError more fills than numbers
HoleCounts find_holes(const StageContext& context);

}  // namespace stream_recon
