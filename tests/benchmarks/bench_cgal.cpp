// Times CGAL's Delaunay tetrahedralization as bench-kernel times ours: the same points, their
// spatial sort included, reading and digest not. CGAL is GPL: this program is never installed.

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdint>
#include <ctime>
#include <numeric>
#include <vector>

#include "spatial/simplex_digest.h"
#include "tools/kernel_bench/kernel_bench.h"

namespace {

using stream_recon::DistinctPoints;
using stream_recon::Point3;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Triangulation = CGAL::Delaunay_triangulation_3<Kernel>;

/// Finds the input index of a point by its coordinates.
class IndexOfPoint {
 public:
  explicit IndexOfPoint(const DistinctPoints& cloud) : cloud_(cloud), order_(cloud.points.size()) {
    std::iota(order_.begin(), order_.end(), 0);
    std::sort(order_.begin(), order_.end(),
              [&](std::uint64_t a, std::uint64_t b) { return cloud.points[a] < cloud.points[b]; });
  }
  std::uint64_t operator()(const Kernel::Point_3& p) const {
    const Point3 wanted{p.x(), p.y(), p.z()};
    const auto found =
        std::lower_bound(order_.begin(), order_.end(), wanted,
                         [&](std::uint64_t a, const Point3& b) { return cloud_.points[a] < b; });
    return cloud_.indices[*found];
  }

 private:
  const DistinctPoints& cloud_;
  std::vector<std::uint64_t> order_;
};

std::string digest_of(const Triangulation& triangulation, const DistinctPoints& cloud) {
  const IndexOfPoint index(cloud);
  stream_recon::SimplexDigest digest;
  for (const auto cell : triangulation.finite_cell_handles()) {
    std::array<std::uint64_t, 4> corners{};
    for (int i = 0; i < 4; ++i) corners[i] = index(cell->vertex(i)->point());
    digest.add(corners);
  }
  return digest.hex();
}

void run(const char* path) {
  const auto source = stream_recon::open_point_source(path, stream_recon::InputFormat::kAuto);
  const DistinctPoints cloud = stream_recon::read_distinct_points(*source);
  std::vector<Kernel::Point_3> points;
  for (const Point3& p : cloud.points) points.emplace_back(p.x, p.y, p.z);

  const auto start = std::chrono::steady_clock::now();
  const std::clock_t busy = std::clock();
  const Triangulation triangulation(points.begin(), points.end());
  const double cpu = static_cast<double>(std::clock() - busy) / CLOCKS_PER_SEC;
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;

  const bool solid = triangulation.dimension() == 3;
  fmt::print(
      R"({{"points": {}, "tetrahedra": {}, "seconds": {}, "cpu_seconds": {}, "digest": "{}"}})"
      "\n",
      points.size(), triangulation.number_of_finite_cells(), seconds.count(), cpu,
      solid ? digest_of(triangulation, cloud) : stream_recon::SimplexDigest().hex());
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    fmt::print(stderr, "usage: bench-cgal FILE\n");
    return 64;
  }
  try {
    run(argv[1]);
    return 0;
  } catch (const std::exception& e) {
    fmt::print(stderr, "bench-cgal: {}\n", e.what());
    return 65;
  }
}
