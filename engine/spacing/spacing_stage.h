// The local spacing of every point (spatial/local_spacing.h), from its exact nearest neighbours
// among all points of the cloud, into a file by rank.
//
// Guarantees: the file's bytes are a function of the cloud and the grid alone, whatever the memory
// and the threads. Thread rule: one caller; works on all threads. Memory: 3 MB and 4 MB a thread;
// up to a quarter of what there is for caches. Cost: about 1 us a point and thread.
#pragma once

#include <cstddef>
#include <optional>

#include "engine/stage_context.h"
#include "engine/windows/cloud_index.h"
#include "io/point_metadata.h"

namespace stream_recon {

/// Name of the spacings (a float for each rank, in the scaled unit of the index) in the scratch
/// directory.
inline constexpr const char* kSpacings = "spacing";

/// Small, because guests of windows ask here and there.
inline constexpr std::size_t kSpacingBlock = std::size_t{16} << 10;

/// Reads the point store and the index. \param grid the distances of the samples along the axes of
/// the grid they were taken from, if known, units of the input: no spacing is below the largest
/// \throw IoError, BudgetError, Interrupted
void measure_spacing(const CloudIndex& index, const std::optional<SampleSpacing>& grid,
                     const StageContext& context);

}  // namespace stream_recon
