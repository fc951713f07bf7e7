#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <stdexcept>

#include "tools/convert/command_line.h"

namespace stream_recon {
namespace {

void require(bool holds, const std::string& message) {
  if (!holds) throw std::invalid_argument(message);
}

std::vector<double> parse_labels(const std::string& text) {
  std::vector<double> labels;
  for (const char *at = text.data(), *end = at + text.size(); at <= end;) {
    long long label = 0;
    const auto [next, error] = std::from_chars(at, end, label);
    require(error == std::errc{} && (next == end || *next == ','),
            fmt::format("--label {}: give a whole number, several as 3,4,7, any or each", text));
    labels.push_back(static_cast<double>(label));
    at = next + 1;
  }
  return labels;
}

std::optional<VoxelSelection> selection_of(const ConverterCommand& line) {
  if (line.above) return VoxelSelection::above(*line.above);
  if (line.at_least) return VoxelSelection::at_least(*line.at_least);
  if (line.label == "any" || line.label == "each") return VoxelSelection::any_label();
  if (!line.label.empty()) return VoxelSelection::of_labels(parse_labels(line.label));
  return std::nullopt;
}

}  // namespace

void check(const ConverterCommand& line) {
  const int given = (line.iso ? 1 : 0) + (line.above ? 1 : 0) + (line.at_least ? 1 : 0) +
                    (line.label.empty() ? 0 : 1);
  require(given == 1, "give one of --iso, --label, --above and --at-least");
  for (const auto& value : {line.iso, line.above, line.at_least}) {
    require(!value || std::isfinite(*value), "--iso, --above and --at-least take a finite number");
  }
  require(!line.iso || !line.boundary_voxels,
          "--boundary-voxels wants an object; use --at-least instead of --iso");
  require(!line.smooth || !line.boundary_voxels,
          "--boundary-voxels are not smoothed; leave --smooth out");
  require(!line.keep_thin || !(line.boundary_voxels || line.iso),
          "--keep-thin is for smoothed objects; leave it out");
  require(line.label != "each" || line.output.path != "-",
          "--label each writes a file for every label; give -o a name");
  for (const double s : line.spacing) {
    require(std::isfinite(s) && s > 0, "--spacing takes three numbers above 0");
  }
  for (const std::size_t n : line.every) require(n >= 1, "--every takes numbers from 1");
  require(line.every.size() != 2, "--every takes one number, or three for i, j and k");
}

VolumeRequest volume_request(const ConverterCommand& line) {
  VolumeRequest request = line.volume;
  request.needs_spacing = line.coordinates == CoordinateSystem::kWorld;
  if (!line.spacing.empty()) request.spacing = {line.spacing[0], line.spacing[1], line.spacing[2]};
  if (!line.dims.empty()) {
    request.raw = RawLayout{
        {line.dims[0], line.dims[1], line.dims[2]}, line.raw_type, line.big_endian, line.skip};
  }
  return request;
}

SamplingOptions sampling_options(const ConverterCommand& line, const VolumeGeometry& geometry) {
  SamplingOptions options;
  options.selection = selection_of(line);
  options.iso = line.iso.value_or(0);
  options.smoothing = {line.smooth.value_or(line.iso ? 0 : 1), line.keep_thin};
  if (line.iso) {
    options.kind = PointKind::kCrossings;
  } else {
    options.kind = line.boundary_voxels ? PointKind::kBoundaryVoxels : PointKind::kSmoothedBoundary;
  }
  options.region = parse_region(line.roi);
  options.every = {line.every[0], line.every[line.every.size() / 2], line.every.back()};
  if (!line.align.empty()) options.offsets = read_slice_alignment(line.align, geometry.size[2]);
  options.coordinates = line.coordinates;
  return options;
}

PointSinkOptions output_options(const ConverterCommand& line) {
  PointSinkOptions options = line.output;
  const PointFormat by_name =
      options.path == "-" ? PointFormat::kPts : point_format_of(options.path);
  options.format = line.format.value_or(by_name);
  return options;
}

}  // namespace stream_recon
