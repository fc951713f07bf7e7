#include "tools/kernel_bench/kernel_bench.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <ctime>
#include <numeric>
#include <utility>

#include "io/error.h"
#include "spatial/delaunay.h"
#include "spatial/hilbert.h"
#include "spatial/regular_triangulation.h"
#include "spatial/simplex_digest.h"
#include "spatial/site.h"
#include "tools/kernel_bench/pole_sites.h"
#include "tools/kernel_bench/radix_sort.h"

namespace stream_recon {
namespace {

class Stopwatch {
 public:
  /// Seconds since the last call, or since the start.
  double lap() {
    const auto now = std::chrono::steady_clock::now();
    return std::chrono::duration<double>(now - std::exchange(last_, now)).count();
  }

 private:
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

std::vector<Point3> read_finite_points(PointSource& source) {
  std::vector<Point3> points;
  std::vector<Point3> buffer(1 << 14);
  while (const std::size_t n = source.read(buffer)) {
    points.insert(points.end(), buffer.begin(), buffer.begin() + static_cast<std::ptrdiff_t>(n));
    for (std::size_t i = points.size() - n; i < points.size(); ++i) {
      if (is_finite(points[i])) continue;
      throw InputError(fmt::format("point {} is not finite: remove it first", i));
    }
  }
  return points;
}

/// True for each point that equals one before it.
std::vector<bool> mark_repeated(const std::vector<Point3>& points) {
  std::vector<std::uint64_t> order(points.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(), [&](std::uint64_t a, std::uint64_t b) {
    if (points[a] == points[b]) return a < b;
    return points[a] < points[b];
  });
  std::vector<bool> repeated(points.size(), false);
  for (std::size_t i = 1; i < order.size(); ++i)
    repeated[order[i]] = points[order[i]] == points[order[i - 1]];
  return repeated;
}

Box3 box_of(const std::vector<Point3>& points) {
  Box3 box;
  for (const Point3& p : points) box.extend(p);
  return box;
}

template <class Site>
std::vector<KeyedNumber> hilbert_order(const std::vector<Site>& sites, const Box3& box) {
  const HilbertCurve curve(box);
  std::vector<KeyedNumber> order(sites.size());
  for (std::uint32_t i = 0; i < order.size(); ++i) order[i] = {curve.key(position(sites[i])), i};
  radix_sort(order);
  return order;
}

template <class Triangulation>
void count_tetrahedra(const Triangulation& triangulation, const std::vector<std::uint64_t>& names,
                      KernelTimes& times) {
  SimplexDigest digest;
  for (CellId c = 0; c < triangulation.cell_slots(); ++c) {
    if (!triangulation.is_live(c) || triangulation.is_infinite(c)) continue;
    std::array<std::uint64_t, 4> corners{};
    const std::array<VertexId, 4> vertices = triangulation.vertices(c);
    for (int i = 0; i < 4; ++i) corners[i] = names[vertices[i]];
    digest.add(corners);
    ++times.tetrahedra;
  }
  times.digest = digest.hex();
}

std::vector<KeyedNumber> order_of(const std::vector<Point3>& points) {
  return hilbert_order(points, box_of(points));
}
std::vector<KeyedNumber> order_of(const PoleCloud& poles) {
  return hilbert_order(poles.sites, poles.box);
}

/// Fills in all but what the digest tells. \return the order of insertion
template <class Triangulation, class Cloud, class Site>
std::vector<KeyedNumber> time_insertion(Triangulation& triangulation, const Cloud& cloud,
                                        const std::vector<Site>& sites, KernelTimes& times) {
  times.points = sites.size();
  const std::clock_t busy = std::clock();
  Stopwatch watch;
  std::vector<KeyedNumber> order = order_of(cloud);
  times.sort_seconds = watch.lap();

  std::vector<Site> ordered(order.size());
  for (std::size_t i = 0; i < order.size(); ++i) ordered[i] = sites[order[i].number];
  const Delaunay::Outcome outcome = triangulation.insert(ordered);
  times.insert_seconds = watch.lap();
  times.cpu_seconds = static_cast<double>(std::clock() - busy) / CLOCKS_PER_SEC;

  if (outcome == Delaunay::Outcome::kBadRange) {
    throw InputError("coordinates too far apart in magnitude for exact arithmetic: scale them");
  }
  times.dimension = triangulation.dimension();
  times.kernel_bytes = triangulation.bytes();
  return order;
}

}  // namespace

DistinctPoints read_distinct_points(PointSource& source) {
  std::vector<Point3> points = read_finite_points(source);
  const std::vector<bool> repeated = mark_repeated(points);
  DistinctPoints cloud;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (repeated[i]) continue;
    cloud.points.push_back(points[i]);
    cloud.indices.push_back(i);
  }
  cloud.duplicates = points.size() - cloud.points.size();
  return cloud;
}

KernelTimes time_kernel(const DistinctPoints& cloud) {
  KernelTimes times;
  Delaunay delaunay;
  const auto order = time_insertion(delaunay, cloud.points, cloud.points, times);
  std::vector<std::uint64_t> names;
  names.reserve(order.size());
  for (const KeyedNumber& entry : order) names.push_back(cloud.indices[entry.number]);
  count_tetrahedra(delaunay, names, times);
  return times;
}

PoleCloud find_poles(const DistinctPoints& cloud) {
  std::vector<Point3> ordered;
  for (const KeyedNumber& entry : order_of(cloud.points))
    ordered.push_back(cloud.points[entry.number]);
  return {pole_sites(ordered), box_of(cloud.points)};
}

KernelTimes time_regular_kernel(const PoleCloud& poles) {
  KernelTimes times;
  RegularTriangulation regular;
  const auto order = time_insertion(regular, poles, poles.sites, times);
  times.hidden = regular.hidden_count();
  std::vector<std::uint64_t> names;
  names.reserve(order.size());
  for (const KeyedNumber& entry : order) names.push_back(entry.number);
  count_tetrahedra(regular, names, times);
  return times;
}

}  // namespace stream_recon
