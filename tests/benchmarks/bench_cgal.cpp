// Times CGAL's Delaunay tetrahedralization, with --poles its regular triangulation, as bench-kernel
// times ours: the same points, their spatial sort included, reading and digest not. CGAL is GPL:
// this program is never installed.

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Regular_triangulation_3.h>
#include <fmt/format.h>
#include <sys/resource.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdint>
#include <ctime>
#include <numeric>
#include <string_view>
#include <vector>

#include "spatial/simplex_digest.h"
#include "tools/kernel_bench/kernel_bench.h"

namespace {

using stream_recon::DistinctPoints;
using stream_recon::Point3;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Triangulation = CGAL::Delaunay_triangulation_3<Kernel>;
using WeightedTriangulation = CGAL::Regular_triangulation_3<Kernel>;

const Kernel::Point_3& place_of(const Kernel::Point_3& p) {
  return p;
}
const Kernel::Point_3& place_of(const Kernel::Weighted_point_3& p) {
  return p.point();
}

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

template <class AnyTriangulation>
std::string digest_of(const AnyTriangulation& triangulation, const DistinctPoints& cloud) {
  const IndexOfPoint index(cloud);
  stream_recon::SimplexDigest digest;
  for (const auto cell : triangulation.finite_cell_handles()) {
    std::array<std::uint64_t, 4> corners{};
    for (int i = 0; i < 4; ++i) corners[i] = index(place_of(cell->vertex(i)->point()));
    digest.add(corners);
  }
  return digest.hex();
}

std::uint64_t peak_bytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<std::uint64_t>(usage.ru_maxrss) << 10;
}

/// \param names for the digest, by place
template <class AnyTriangulation, class Site>
void time_triangulation(const std::vector<Site>& sites, const DistinctPoints& names) {
  const std::uint64_t peak_before = peak_bytes();
  const auto start = std::chrono::steady_clock::now();
  const std::clock_t busy = std::clock();
  const AnyTriangulation triangulation(sites.begin(), sites.end());
  const double cpu = static_cast<double>(std::clock() - busy) / CLOCKS_PER_SEC;
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
  const auto bytes = static_cast<double>(peak_bytes() - peak_before);

  const bool solid = triangulation.dimension() == 3;
  fmt::print(R"({{"points": {}, "hidden": {}, "tetrahedra": {}, "seconds": {}, "cpu_seconds": {}, )"
             R"("bytes_per_point": {}, "digest": "{}"}})"
             "\n",
             sites.size(), sites.size() - triangulation.number_of_vertices(),
             triangulation.number_of_finite_cells(), seconds.count(), cpu,
             bytes / static_cast<double>(sites.size()),
             solid ? digest_of(triangulation, names) : stream_recon::SimplexDigest().hex());
}

void run(const char* path, bool has_poles) {
  const auto source = stream_recon::open_point_source(path, stream_recon::InputFormat::kAuto);
  const DistinctPoints cloud = stream_recon::read_distinct_points(*source);
  if (!has_poles) {
    std::vector<Kernel::Point_3> points;
    for (const Point3& p : cloud.points) points.emplace_back(p.x, p.y, p.z);
    return time_triangulation<Triangulation>(points, cloud);
  }
  std::vector<Kernel::Weighted_point_3> sites;
  DistinctPoints names;
  for (const auto& [p, weight] : stream_recon::find_poles(cloud).sites) {
    sites.emplace_back(Kernel::Point_3(p.x, p.y, p.z), weight);
    names.indices.push_back(names.points.size());
    names.points.push_back(p);
  }
  time_triangulation<WeightedTriangulation>(sites, names);
}

}  // namespace

int main(int argc, char** argv) {
  const bool has_poles = argc == 3 && std::string_view(argv[1]) == "--poles";
  if (argc != 2 && !has_poles) {
    fmt::print(stderr, "usage: bench-cgal [--poles] FILE\n");
    return 64;
  }
  try {
    run(argv[argc - 1], has_poles);
    return 0;
  } catch (const std::exception& e) {
    fmt::print(stderr, "bench-cgal: {}\n", e.what());
    return 65;
  }
}
