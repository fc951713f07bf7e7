// A volume's points into files: what slices-to-points does once its options are read.
//
// Guarantees: a cloud stands under its name complete or not at all; of `each`, some labels' clouds
// may stand there when a later one fails. Thread rule: one caller.
#pragma once

#include <cstdint>
#include <string>

#include "tools/points/point_sink.h"
#include "tools/sampling/sampling.h"

namespace stream_recon {

/// Writes one cloud; `output.metadata` and `output.count` are filled in. A PLY on standard output
/// takes a pass of counting before.
/// \throw InputError, IoError, std::invalid_argument
SampleCounts write_points(Volume& volume, const SamplingOptions& options, PointSinkOptions output);

/// Writes a cloud for every label, OUT_13.ply for label 13 and `output.path` OUT.ply.
/// \throw as write_points
struct LabelCounts {
  std::size_t labels = 0;
  std::uint64_t points = 0;           ///< of all labels
  std::vector<double> smoothed_away;  ///< labels without a point: they have no file
};
LabelCounts write_each_label(Volume& volume, const SamplingOptions& options,
                             const PointSinkOptions& output);

/// out.ply, 13 -> out_13.ply
std::string label_path(const std::string& path, double label);

}  // namespace stream_recon
