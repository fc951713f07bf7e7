// slices-to-points: points of the surfaces in a volume or a stack of slices.

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <spdlog/spdlog.h>

#include <charconv>
#include <cmath>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "tools/run_tool.h"
#include "tools/sampling/conversion.h"
#include "tools/slices/open_volume.h"

namespace {

using namespace stream_recon;

struct CommandLine {
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

  PointSinkOptions output;
  bool has_format = false;
};

void require(bool holds, const std::string& message) {
  if (!holds) throw std::invalid_argument(message);
}

void add_input_options(CLI::App& app, CommandLine& line) {
  app.add_option("INPUT", line.volume.paths,
                 "A volume (NIfTI, NRRD, MetaImage, multi-page TIFF, DICOM), a folder of slices "
                 "(DICOM, PNG, TIFF, JPEG, BMP), or slices in their order")
      ->required();
  app.add_option("--spacing", line.spacing,
                 "Distance of neighbouring voxels along i, j, k, instead of the file's")
      ->delimiter(',')
      ->expected(3)
      ->option_text("X,Y,Z");
  app.add_option("--series", line.volume.series,
                 "DICOM: the series, by its UID, the UID's ending or its number from 1")
      ->option_text("ID");
  app.add_option("--dims", line.dims, "Raw voxels without a header: voxels along i, j, k")
      ->delimiter(',')
      ->expected(3)
      ->option_text("X,Y,Z");
  const std::map<std::string, RawType> types{
      {"u8", RawType::kUint8},    {"i8", RawType::kInt8},    {"u16", RawType::kUint16},
      {"i16", RawType::kInt16},   {"u32", RawType::kUint32}, {"i32", RawType::kInt32},
      {"f32", RawType::kFloat32}, {"f64", RawType::kFloat64}};
  app.add_option("--type", line.raw_type, "Raw: u8 (default), i8, u16, i16, u32, i32, f32 or f64")
      ->transform(CLI::CheckedTransformer(types))
      ->needs("--dims")
      ->option_text("TYPE");
  app.add_flag("--big-endian", line.big_endian, "Raw: most significant byte first")
      ->needs("--dims");
  app.add_option("--skip", line.skip, "Raw: bytes before the first voxel of each file")
      ->needs("--dims")
      ->option_text("BYTES");
}

void add_selection_options(CLI::App& app, CommandLine& line) {
  app.add_option("--iso", line.iso, "Points where grid edges cross this value")->option_text("V");
  app.add_option("--label", line.label,
                 "The boundary of a label, of several as one (3,4,7), of any, or of each, a file "
                 "for every label")
      ->option_text("LABELS");
  app.add_option("--above", line.above, "The boundary of the voxels above this value")
      ->option_text("V");
  app.add_option("--at-least", line.at_least, "The boundary of the voxels of this value and more")
      ->option_text("V");
  app.add_flag("--boundary-voxels", line.boundary_voxels,
               "Centres of object voxels that have a face neighbour outside, instead of points on "
               "the smoothed boundary");
  app.add_option("--smooth", line.smooth,
                 "Standard deviation of the smoothing, voxels (default: 1 for objects, 0, that is "
                 "none, for --iso)")
      ->check(CLI::Range(0.0, 20.0))
      ->option_text("S");
  app.add_flag("--keep-thin", line.keep_thin,
               "Objects: smoothing moves no voxel to the other side, so that nothing thin is lost "
               "(what is thinner than 1.35 S is otherwise); the points make rougher surfaces");
}

void add_grid_options(CLI::App& app, CommandLine& line) {
  app.add_option("--roi", line.roi, "Only these voxels, each range without its end: 10:200,:,5:40")
      ->option_text("I:I,J:J,K:K");
  app.add_option("--every", line.every, "Only every n-th voxel: one number, or one for i, j, k")
      ->delimiter(',')
      ->expected(1, 3)
      ->option_text("N");
  app.add_option("--align", line.align,
                 "File that says how far slices must be moved: lines \"slice di dj\", in voxels")
      ->option_text("FILE");
  const std::map<std::string, CoordinateSystem> systems{{"world", CoordinateSystem::kWorld},
                                                        {"index", CoordinateSystem::kIndex}};
  app.add_option("--coordinates", line.coordinates,
                 "world (default: spacing, origin and direction apply) or index (voxel numbers)")
      ->transform(CLI::CheckedTransformer(systems))
      ->option_text("KIND");
}

CLI::Option* add_output_options(CLI::App& app, CommandLine& line) {
  app.add_option("-o,--output", line.output.path, "File, or - for standard output")
      ->required()
      ->option_text("OUT");
  const std::map<std::string, Scalar> scalars{{"float", Scalar::kFloat32},
                                              {"double", Scalar::kFloat64}};
  app.add_option("--scalar", line.output.scalar,
                 "Coordinates of ply and pts: float (default) or double")
      ->transform(CLI::CheckedTransformer(scalars))
      ->option_text("TYPE");
  const std::map<std::string, PointFormat> formats{{"ply", PointFormat::kPly},
                                                   {"xyz", PointFormat::kXyz},
                                                   {"f32", PointFormat::kF32},
                                                   {"f64", PointFormat::kF64},
                                                   {"pts", PointFormat::kPts}};
  return app
      .add_option("--output-format", line.output.format,
                  "ply, xyz, f32, f64 or pts (default: by the name's ending, else ply; for - pts, "
                  "which stream-recon - understands)")
      ->transform(CLI::CheckedTransformer(formats))
      ->option_text("FORMAT");
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

std::optional<VoxelSelection> selection_of(const CommandLine& line) {
  if (line.above) return VoxelSelection::above(*line.above);
  if (line.at_least) return VoxelSelection::at_least(*line.at_least);
  if (line.label == "any" || line.label == "each") return VoxelSelection::any_label();
  if (!line.label.empty()) return VoxelSelection::of_labels(parse_labels(line.label));
  return std::nullopt;
}

void check_combinations(const CommandLine& line) {
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

VolumeRequest volume_request(const CommandLine& line) {
  VolumeRequest request = line.volume;
  request.needs_spacing = line.coordinates == CoordinateSystem::kWorld;
  if (!line.spacing.empty()) request.spacing = {line.spacing[0], line.spacing[1], line.spacing[2]};
  if (!line.dims.empty()) {
    request.raw = RawLayout{
        {line.dims[0], line.dims[1], line.dims[2]}, line.raw_type, line.big_endian, line.skip};
  }
  return request;
}

SamplingOptions sampling_options(const CommandLine& line, const VolumeGeometry& geometry) {
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

void convert(CommandLine& line) {
  check_combinations(line);
  if (!line.has_format) {
    line.output.format =
        line.output.path == "-" ? PointFormat::kPts : point_format_of(line.output.path);
  }
  const auto volume = open_volume(volume_request(line));
  const SamplingOptions options = sampling_options(line, volume->geometry());
  const auto& size = volume->geometry().size;
  const std::string from =
      fmt::format("{} x {} x {} voxels of {}", size[0], size[1], size[2], volume->source());
  if (line.label == "each") {
    const LabelCounts counts = write_each_label(*volume, options, line.output);
    spdlog::info("{} labels, {} points, from {}", counts.labels, counts.points, from);
    if (!counts.smoothed_away.empty()) {
      spdlog::warn(
          "all voxels of these labels are smoothed away, they have no file: {}; add "
          "--keep-thin, or smooth less",
          fmt::join(counts.smoothed_away, ", "));
    }
    return;
  }
  const SampleCounts counts = write_points(*volume, options, line.output);
  const std::string what = Sampling(*volume, options).description();
  if (line.iso) {
    spdlog::info("{} points: {}, from {}", counts.points, what, from);
  } else {
    const bool moved = counts.voxels_lost + counts.voxels_gained > 0;
    spdlog::info("{} points: {}, {} voxels{}, from {}", counts.points, what, counts.voxels,
                 moved ? fmt::format(" (smoothing took {} and added {})", counts.voxels_lost,
                                     counts.voxels_gained)
                       : "",
                 from);
  }
}

constexpr const char* kFooter =
    "Objects (--label, --above, --at-least) are closed at the volume's edge, and so at that of\n"
    "--roi; --iso is open there. By default an object's points lie on its smoothed boundary;\n"
    "how many voxels smoothing took from it, and added, is said.\n"
    "Memory is a few slices, however long the stack.";

}  // namespace

int main(int argc, char** argv) {
  CommandLine line;
  line.output.scalar = Scalar::kFloat32;
  CLI::App app("Writes points of the surfaces in a volume or a stack of slices",
               "slices-to-points");
  app.footer(kFooter);
  add_input_options(app, line);
  add_selection_options(app, line);
  add_grid_options(app, line);
  const CLI::Option* format = add_output_options(app, line);
  return run_tool(app, argc, argv, [&] {
    line.has_format = format->count() > 0;
    convert(line);
  });
}
