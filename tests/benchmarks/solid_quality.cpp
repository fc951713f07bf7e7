// Measures the mesh of a known solid against the truth; prints JSON: what mesh-check prints
// (docs/mesh-check.md), and
//
//   wrong_volume     volume labelled wrongly, as a share of the true volume
//   odd_rays         rays that cross the mesh an odd number of times; 0 if it is closed
//   measured_volume  of the solid, by the rays of the measurement, as a share of the true volume
//   true_volume, true_area, true_euler
// with --cloud
//   samples          different points of the cloud
//   on_surface       share of them that are vertices of the mesh
//   added_vertices   vertices of the mesh that are no samples
// with --cloud that has a spacing
//   voxel_bias       what the mean distance of the samples from the surface, all over the surface,
//                    is of the true volume

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "io/mesh_source.h"
#include "io/point_source.h"
#include "tests/benchmarks/label_error.h"
#include "tests/benchmarks/sample_distance.h"
#include "tests/benchmarks/sample_match.h"
#include "tools/check/facts_text.h"
#include "tools/check/mesh_check.h"
#include "tools/clouds/known_solid.h"
#include "tools/run_tool.h"

namespace {

using namespace stream_recon;
using Json = nlohmann::ordered_json;

struct CommandLine {
  SolidOptions solid;
  std::string mesh;
  std::string cloud;
  double cell = 0.005;
};

class MeshTaker final : public MeshVisitor {
 public:
  explicit MeshTaker(LabelErrorMeter& meter) : meter_(meter) {}
  void vertex(std::uint64_t /*number*/, const Point3& point) override {
    vertices_.push_back(point);
  }
  void triangle(const MeshTriangle& /*corners*/, const std::array<Point3, 3>& points) override {
    meter_.add_triangle(points);
  }
  std::vector<Point3> take_vertices() { return std::move(vertices_); }

 private:
  LabelErrorMeter& meter_;
  std::vector<Point3> vertices_;
};

void add_cloud(const CommandLine& line, const KnownSolid& solid, std::vector<Point3> vertices,
               Json& json) {
  const auto source = open_point_source(line.cloud, InputFormat::kAuto);
  std::vector<Point3> samples;
  std::vector<Point3> buffer(4096);
  while (const std::size_t n = source->read(buffer))
    samples.insert(samples.end(), buffer.begin(), buffer.begin() + static_cast<std::ptrdiff_t>(n));
  if (const auto& spacing = source->metadata().spacing) {
    const double reach = 4 * *std::max_element(spacing->begin(), spacing->end());
    const SolidTruth truth = solid.truth();
    json["voxel_bias"] = mean_distance(solid, samples, reach) * truth.area / truth.volume;
  }
  const SampleMatch match = match_samples(std::move(samples), std::move(vertices));
  json["samples"] = match.samples;
  json["on_surface"] = static_cast<double>(match.matched) / static_cast<double>(match.samples);
  json["added_vertices"] = match.added_vertices;
}

void measure(const CommandLine& line) {
  const auto solid = make_solid(line.solid);
  const SolidTruth truth = solid->truth();
  MeshCheckOptions check;
  check.path = line.mesh;
  Json json = Json::parse(facts_json(check_mesh(check)));

  LabelErrorMeter meter(*solid, line.cell);
  MeshTaker taker(meter);
  ScratchDirectory scratch({.parent = std::filesystem::temp_directory_path().string()});
  open_mesh_source({.path = line.mesh, .scratch = &scratch})->read(taker);
  const LabelError error = meter.measure();
  json["wrong_volume"] = error.wrong_volume / truth.volume;
  json["odd_rays"] = error.odd_rays;
  json["measured_volume"] = error.solid_volume / truth.volume;
  json["true_volume"] = truth.volume;
  json["true_area"] = truth.area;
  json["true_euler"] = truth.euler;
  if (!line.cloud.empty()) add_cloud(line, *solid, taker.take_vertices(), json);
  fmt::print("{}\n", json.dump(2));
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Measures the mesh of a known solid against the truth", "solid-quality");
  CommandLine line;
  app.add_option("SOLID", line.solid.name, fmt::format("{}", fmt::join(solid_names(), ", ")))
      ->required();
  app.add_option("MESH", line.mesh, "Its mesh: .pvtp, .vtp, .ply or .vtk")->required();
  app.add_option("--width", line.solid.width, "As make-cloud's");
  app.add_option("--cloud", line.cloud, "The samples that the mesh was made from");
  app.add_option("--cell", line.cell, "Distance of the rays that measure volume")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  return run_tool(app, argc, argv, [&line] { measure(line); });
}
