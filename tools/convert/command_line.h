// The command line of slices-to-points: its options, and what they ask of the readers and samplers.
//
// Thread rule: values.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "tools/points/point_sink.h"
#include "tools/run_tool.h"
#include "tools/sampling/sampling.h"
#include "tools/slices/open_volume.h"

namespace stream_recon {

/// What was given, as it was given.
struct ConverterCommand {
  VolumeRequest volume;
  std::vector<std::size_t> dims;
  RawType raw_type = RawType::kUint8;
  bool big_endian = false;
  std::uint64_t skip = 0;

  std::optional<double> iso, above, at_least;
  std::string label;
  bool boundary_voxels = false, keep_thin = false;
  std::optional<double> smooth;

  std::vector<double> spacing;
  std::string roi = ":,:,:";
  std::vector<std::size_t> every{1};
  std::string align;
  CoordinateSystem coordinates = CoordinateSystem::kWorld;

  PointSinkOptions output{.path = {}, .scalar = Scalar::kFloat32};
  std::optional<PointFormat> format;  ///< else by the output's name
};

/// Makes the options of `app` write into `command`, which must outlive the parsing.
void add_converter_options(CLI::App& app, ConverterCommand& command);

/// \throw std::invalid_argument options that contradict each other or make no sense
void check(const ConverterCommand& command);

/// \pre check() passed, for all below
VolumeRequest volume_request(const ConverterCommand& command);

/// \throw std::invalid_argument, InputError, IoError region, labels or offsets that cannot be used
SamplingOptions sampling_options(const ConverterCommand& command, const VolumeGeometry& geometry);

PointSinkOptions output_options(const ConverterCommand& command);

}  // namespace stream_recon
