// The one pass over the input: everything the run must know before it can order the points.
//
// Guarantees: the spool has every finite point of all inputs in input order; the index counts on
// from input to input and counts rejected points too. Thread rule: one caller; compresses on
// all threads. Memory: about 4 MB and 3 MB a thread, whatever the input's size.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "engine/stage_context.h"
#include "io/point_source.h"
#include "spatial/box.h"
#include "spatial/coordinate_range.h"

namespace stream_recon {

struct IngestOptions {
  std::vector<std::string> inputs;  ///< at least one, "-" for standard input
  InputFormat format = InputFormat::kAuto;
  /// Adds eight points far around the cloud, numbered on from the last input point.
  bool adds_far_points = false;
};

struct CloudSummary {
  std::uint64_t points = 0;      ///< as delivered, rejected ones included
  std::uint64_t rejected = 0;    ///< not finite
  std::uint64_t far_points = 0;  ///< added to those delivered
  std::uint64_t bytes = 0;       ///< of the inputs, as they lay there
  Box3 box;                      ///< of the finite points, far points as well
  CoordinateRange range;         ///< of the same
  bool fits_float32 = true;      ///< every coordinate is a float32
  /// Of the grid the points were sampled on, along its axes: of all inputs that say one, the
  /// widest.
  std::optional<SampleSpacing> spacing;

  /// Far points as well.
  std::uint64_t finite_points() const { return points - rejected + far_points; }
};

/// Name of the spool (records of StoredPoint) in the scratch directory.
inline constexpr const char* kIngestSpool = "ingest";
inline constexpr std::size_t kIngestBlock = std::size_t{1} << 19;

/// \throw InputError, IoError, BudgetError, Interrupted
CloudSummary ingest(const IngestOptions& options, const StageContext& context);

}  // namespace stream_recon
