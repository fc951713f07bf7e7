// bench-kernel: times the in-core Delaunay tetrahedralization of a cloud, or the regular
// triangulation of its poles.

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "tools/kernel_bench/kernel_bench.h"
#include "tools/run_tool.h"

namespace {

using stream_recon::DistinctPoints;
using stream_recon::KernelTimes;

double per_point(std::uint64_t amount, const KernelTimes& times) {
  return times.points == 0 ? 0 : static_cast<double>(amount) / static_cast<double>(times.points);
}

double rate(const KernelTimes& times) {
  return times.seconds() > 0 ? static_cast<double>(times.points) / times.seconds() : 0;
}

void print_json(const KernelTimes& times, const DistinctPoints& cloud, int threads) {
  const nlohmann::ordered_json result{{"points", times.points},
                                      {"duplicates", cloud.duplicates},
                                      {"hidden", times.hidden},
                                      {"dimension", times.dimension},
                                      {"tetrahedra", times.tetrahedra},
                                      {"seconds", times.seconds()},
                                      {"sort_seconds", times.sort_seconds},
                                      {"insert_seconds", times.insert_seconds},
                                      {"cpu_seconds", times.cpu_seconds},
                                      {"points_per_second", rate(times)},
                                      {"kernel_bytes", times.kernel_bytes},
                                      {"bytes_per_point", per_point(times.kernel_bytes, times)},
                                      {"digest", times.digest},
                                      {"threads", threads}};
  fmt::print("{}\n", result.dump(2));
}

void print_text(const KernelTimes& times, const DistinctPoints& cloud) {
  fmt::print("points      {:>12}  ({} duplicates removed)\n", times.points, cloud.duplicates);
  if (times.hidden > 0) fmt::print("hidden      {:>12}\n", times.hidden);
  fmt::print("tetrahedra  {:>12}  (dimension {})\n", times.tetrahedra, times.dimension);
  fmt::print("seconds     {:>12.3f}  (sort {:.3f}, insertion {:.3f})\n", times.seconds(),
             times.sort_seconds, times.insert_seconds);
  fmt::print("points/s    {:>12.0f}\n", rate(times));
  fmt::print("bytes       {:>12}  ({:.0f} a point)\n", times.kernel_bytes,
             per_point(times.kernel_bytes, times));
  fmt::print("digest      {}\n", times.digest);
}

}  // namespace

int main(int argc, char** argv) {
  std::string path;
  int threads = 1;
  bool poles = false;
  bool json = false;
  CLI::App app(
      "Times the in-core Delaunay tetrahedralization of a cloud, its spatial sort included",
      "bench-kernel");
  app.add_option("file", path, "Point cloud of any format that stream-recon reads, - for a pipe")
      ->required();
  app.add_option("--threads", threads,
                 "Accepted for later: keys, sort and kernel use one thread so far")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  app.add_flag(
      "--poles", poles,
      "Triangulate the cloud's poles with their weights instead; finding them is not timed");
  app.add_flag("--json", json, "Print JSON");
  return stream_recon::run_tool(app, argc, argv, [&] {
    const auto source = stream_recon::open_point_source(path, stream_recon::InputFormat::kAuto);
    const DistinctPoints cloud = stream_recon::read_distinct_points(*source);
    const KernelTimes times =
        poles ? stream_recon::time_regular_kernel(stream_recon::find_poles(cloud))
              : stream_recon::time_kernel(cloud);
    if (json) return print_json(times, cloud, threads);
    print_text(times, cloud);
  });
}
