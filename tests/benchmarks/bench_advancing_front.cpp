// Times CGAL's advancing front surface reconstruction on a cloud: its Delaunay structure and its
// front, reading not. CGAL is GPL: this program is never installed.

#include <CGAL/Advancing_front_surface_reconstruction.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdint>
#include <iterator>
#include <vector>

#include "engine/process_memory.h"
#include "tools/kernel_bench/kernel_bench.h"

namespace {

using stream_recon::DistinctPoints;
using stream_recon::Point3;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Facet = std::array<std::size_t, 3>;

/// Edges with one triangle only.
std::uint64_t count_boundary_edges(const std::vector<Facet>& facets) {
  std::vector<std::array<std::size_t, 2>> edges;
  for (const Facet& facet : facets) {
    for (std::size_t i = 0; i < 3; ++i) {
      const auto [low, high] = std::minmax(facet[i], facet[(i + 1) % 3]);
      edges.push_back({low, high});
    }
  }
  std::sort(edges.begin(), edges.end());
  std::uint64_t count = 0;
  for (auto first = edges.begin(); first != edges.end();) {
    const auto last = std::upper_bound(first, edges.end(), *first);
    count += last - first == 1 ? 1 : 0;
    first = last;
  }
  return count;
}

void run(const char* path) {
  const auto source = stream_recon::open_point_source(path, stream_recon::InputFormat::kAuto);
  std::vector<Kernel::Point_3> points;
  for (const Point3& p : stream_recon::read_distinct_points(*source).points)
    points.emplace_back(p.x, p.y, p.z);

  const auto start = std::chrono::steady_clock::now();
  std::vector<Facet> facets;
  CGAL::advancing_front_surface_reconstruction(points.begin(), points.end(),
                                               std::back_inserter(facets));
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;

  const std::uint64_t peak = stream_recon::peak_resident_bytes();
  fmt::print(
      R"({{"points": {}, "triangles": {}, "boundary_edges": {}, "seconds": {}, "peak_rss_bytes": {}}})"
      "\n",
      points.size(), facets.size(), count_boundary_edges(facets), seconds.count(), peak);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    fmt::print(stderr, "usage: bench-advancing-front FILE\n");
    return 64;
  }
  try {
    run(argv[1]);
    return 0;
  } catch (const std::exception& e) {
    fmt::print(stderr, "bench-advancing-front: {}\n", e.what());
    return 65;
  }
}
