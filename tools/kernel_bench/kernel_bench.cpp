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
#include "spatial/simplex_digest.h"
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

std::vector<KeyedNumber> hilbert_order(const std::vector<Point3>& points) {
  Box3 box;
  for (const Point3& p : points) box.extend(p);
  const HilbertCurve curve(box);
  std::vector<KeyedNumber> order(points.size());
  for (std::uint32_t i = 0; i < order.size(); ++i) order[i] = {curve.key(points[i]), i};
  radix_sort(order);
  return order;
}

void count_tetrahedra(const Delaunay& delaunay, const std::vector<KeyedNumber>& order,
                      const DistinctPoints& cloud, KernelTimes& times) {
  SimplexDigest digest;
  for (CellId c = 0; c < delaunay.cell_slots(); ++c) {
    if (!delaunay.is_live(c) || delaunay.is_infinite(c)) continue;
    std::array<std::uint64_t, 4> corners{};
    const std::array<VertexId, 4> vertices = delaunay.vertices(c);
    for (int i = 0; i < 4; ++i) corners[i] = cloud.indices[order[vertices[i]].number];
    digest.add(corners);
    ++times.tetrahedra;
  }
  times.digest = digest.hex();
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
  times.points = cloud.points.size();
  const std::clock_t busy = std::clock();
  Stopwatch watch;
  const std::vector<KeyedNumber> order = hilbert_order(cloud.points);
  times.sort_seconds = watch.lap();

  std::vector<Point3> ordered(order.size());
  for (std::size_t i = 0; i < order.size(); ++i) ordered[i] = cloud.points[order[i].number];
  Delaunay delaunay;
  const Delaunay::Outcome outcome = delaunay.insert(ordered);
  times.insert_seconds = watch.lap();
  times.cpu_seconds = static_cast<double>(std::clock() - busy) / CLOCKS_PER_SEC;

  if (outcome == Delaunay::Outcome::kBadRange) {
    throw InputError("coordinates too far apart in magnitude for exact arithmetic: scale them");
  }
  times.dimension = delaunay.dimension();
  times.kernel_bytes = delaunay.bytes();
  count_tetrahedra(delaunay, order, cloud, times);
  return times;
}

}  // namespace stream_recon
