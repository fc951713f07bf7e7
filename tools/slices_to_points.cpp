// slices-to-points: the points where a volume crosses a value.

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <cmath>
#include <map>
#include <stdexcept>
#include <vector>

#include "tools/points/point_sink.h"
#include "tools/run_tool.h"
#include "tools/slices/iso_points.h"
#include "tools/slices/open_volume.h"

namespace {

using stream_recon::Point3;
using stream_recon::PointFormat;
using stream_recon::Scalar;

// A PLY header tells the count, so that format takes a counting scan first.
void write_iso_points(const std::string& path, double iso, stream_recon::PointSinkOptions output) {
  const auto volume =
      stream_recon::open_volume({.paths = {path}, .spacing = {}, .series = {}, .raw = {}});
  if (output.format == PointFormat::kPly)
    output.count = stream_recon::scan_iso_points(*volume, iso, [](const Point3&) {});
  stream_recon::PointSink sink(output);
  stream_recon::scan_iso_points(*volume, iso, [&](const Point3& p) { sink.write({&p, 1}); });
  sink.finish();
  const auto& size = volume->geometry().size;
  spdlog::info("{} points where the {} x {} x {} volume crosses {}", sink.points_written(), size[0],
               size[1], size[2], iso);
}

constexpr const char* kFooter =
    "Points are in the volume's physical space (spacing, origin and direction applied), in the\n"
    "file's units. They are computed in double and written as float by default, as viewers "
    "expect;\n"
    "--scalar double keeps every bit. Memory is a few slices where ITK reads the format in parts\n"
    "(uncompressed NRRD, MetaImage), the volume in its own voxel type elsewhere (NIfTI).";

}  // namespace

int main(int argc, char** argv) {
  std::string path;
  double iso = 0;
  stream_recon::PointSinkOptions output;
  output.scalar = Scalar::kFloat32;
  CLI::App app("Writes the points where the grid edges of a volume cross a value",
               "slices-to-points");
  app.footer(kFooter);
  app.add_option("volume", path, "Volume file that ITK reads: NIfTI, NRRD, MetaImage, ...")
      ->required();
  app.add_option("--iso", iso, "The value, in the units of the voxels")->required();
  app.add_option("-o,--output", output.path, "File, or - for standard output")->required();
  const std::map<std::string, PointFormat> formats{{"ply", PointFormat::kPly},
                                                   {"xyz", PointFormat::kXyz},
                                                   {"f32", PointFormat::kF32},
                                                   {"f64", PointFormat::kF64}};
  const auto* format =
      app.add_option("--output-format", output.format,
                     "ply, xyz, f32 or f64 (default: by the name's ending, else ply)")
          ->transform(CLI::Transformer(formats));
  const std::map<std::string, Scalar> scalars{{"float", Scalar::kFloat32},
                                              {"double", Scalar::kFloat64}};
  app.add_option("--scalar", output.scalar, "Coordinates of a PLY: float (default) or double")
      ->transform(CLI::Transformer(scalars));
  return stream_recon::run_tool(app, argc, argv, [&] {
    if (!std::isfinite(iso)) throw std::invalid_argument("--iso must be a finite number");
    if (format->count() == 0) output.format = stream_recon::point_format_of(output.path);
    write_iso_points(path, iso, output);
  });
}
