// From the windows' faces to the crust as a surface over a point store of its own.
//
// Guarantees: the store has every vertex of the crust once, in the order of names: near the
// samples' Hilbert order. A vertex that is a sample has its coordinates and input index, bit for
// bit; the others are numbered on from input_points, in the order of the store. Store and facets
// are functions of the poles alone, not of the windows. Thread rule: one caller; sorts on all
// threads. Memory: two sorts, two fifths of what there is for each, of 56 and 12 bytes a vertex and
// window; what they do not hold goes to disk. 4 bytes a vertex of one window.
// Source: docs/algorithms/crust.md
#pragma once

#include <cstdint>

#include "engine/crust/crust_windows.h"
#include "engine/stage_context.h"

namespace stream_recon {

/// Name of the store (records of StoredPoint) in the scratch directory.
inline constexpr const char* kCrustPoints = "crust_points";
/// Of its facets' exports.
inline constexpr std::string_view kCrustPrefix = "crust_facets_";

struct CrustAssemblyOptions {
  std::uint64_t input_points = 0;  ///< input indices below this are taken; far points have some
  std::uint64_t chunk_points = 1;  ///< vertices that share a chunk, >= 1
};

struct CrustFacts {
  std::uint64_t vertices = 0;
  std::uint64_t samples = 0;  ///< among them
  CoordinateRange range;
};

/// Reads and removes the windows' files.
/// \throw IoError, BudgetError, Interrupted; InputError more vertices than ranks
CrustFacts assemble_crust(const CrustWindows& windows, const CrustAssemblyOptions& options,
                          const StageContext& context);

}  // namespace stream_recon
