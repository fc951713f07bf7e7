// make-cloud: seeded synthetic clouds of any size, written as a stream.

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <map>
#include <vector>

#include "tools/clouds/cloud.h"
#include "tools/points/point_sink.h"
#include "tools/run_tool.h"

namespace {

using stream_recon::PointFormat;
using stream_recon::Scalar;
using stream_recon::SolidSampling;

std::map<std::string, SolidSampling> sampling_names() {
  std::map<std::string, SolidSampling> names;
  int i = 0;
  for (const char* name : stream_recon::kSolidSamplingNames)
    names.emplace(name, static_cast<SolidSampling>(i++));
  return names;
}

std::string footer() {
  std::string text = "Kinds:\n";
  for (const stream_recon::CloudKind& kind : stream_recon::cloud_kinds())
    text += fmt::format("  {:10} {}\n", kind.name, kind.description);
  text += fmt::format("Solids, of which the truth is known: {}.\n",
                      fmt::join(stream_recon::solid_names(), ", "));
  return text +
         "Noisy samples of a solid are random ones, moved along the normal. The others are what\n"
         "a segmentation leaves, on a grid of voxels as fine as N points need: crossings of the\n"
         "surface and grid edges; centres of the faces between inside and outside voxels; centres\n"
         "of inside voxels with an outside face neighbour. A pts stream of them tells the pixel.\n"
         "The same options give the same bytes on every machine.";
}

void write_cloud(const stream_recon::CloudOptions& cloud, stream_recon::PointSinkOptions output) {
  const auto source = stream_recon::make_cloud(cloud);
  output.count = source->announced_count().value();
  output.metadata = source->metadata();
  stream_recon::PointSink sink(output);
  std::vector<stream_recon::Point3> buffer(4096);
  while (const std::size_t n = source->read(buffer)) sink.write({buffer.data(), n});
  sink.finish();
  spdlog::info("{} points of {}", sink.points_written(), cloud.kind);
}

}  // namespace

int main(int argc, char** argv) {
  stream_recon::CloudOptions cloud;
  stream_recon::PointSinkOptions output;
  CLI::App app("Writes a seeded synthetic point cloud of any size as a stream", "make-cloud");
  app.footer(footer);
  app.add_option("kind", cloud.kind, "Kind of cloud, see below")->required();
  app.add_option("-n,--points", cloud.points, "Number of points; samples on a grid come close")
      ->capture_default_str();
  app.add_option("--seed", cloud.seed, "Seed of the random kinds")->capture_default_str();
  const std::map<std::string, SolidSampling> samplings = sampling_names();
  app.add_option("--sampling", cloud.sampling,
                 "random, noisy, crossings, faces or centres; of solids (default: random)")
      ->transform(CLI::Transformer(samplings))
      ->option_text("NAME");
  app.add_option("--slice-step", cloud.slice_step,
                 "Distance of slices, pixels: shell, crossings, faces, centres")
      ->capture_default_str();
  app.add_option("--noise", cloud.noise, "Deviation of noisy samples, in units of the mean spacing")
      ->capture_default_str();
  app.add_option("--width", cloud.width,
                 "Gap of the pair, thickness of the plate, below 1 (default: 0.05)");
  app.add_option("-o,--output", output.path, "File, or - for standard output")->required();
  const std::map<std::string, PointFormat> formats{{"ply", PointFormat::kPly},
                                                   {"xyz", PointFormat::kXyz},
                                                   {"f32", PointFormat::kF32},
                                                   {"f64", PointFormat::kF64},
                                                   {"pts", PointFormat::kPts}};
  const auto* format =
      app.add_option("--format", output.format,
                     "ply, xyz, f32, f64 or pts (default: by the name's ending, else ply)")
          ->transform(CLI::Transformer(formats));
  const std::map<std::string, Scalar> scalars{{"float", Scalar::kFloat32},
                                              {"double", Scalar::kFloat64}};
  app.add_option("--scalar", output.scalar, "Coordinates of a PLY: float or double (default)")
      ->transform(CLI::Transformer(scalars));
  return stream_recon::run_tool(app, argc, argv, [&] {
    if (format->count() == 0) output.format = stream_recon::point_format_of(output.path);
    write_cloud(cloud, output);
  });
}
