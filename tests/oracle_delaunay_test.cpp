// The kernel's tetrahedra are those of CGAL, cospherical ties included.
#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_vertex_base_with_info_3.h>
#include <gtest/gtest.h>

#include <cstdio>
#include <filesystem>
#include <numeric>
#include <random>
#include <vector>

#include "io/point_source.h"
#include "spatial/delaunay.h"
#include "spatial/hilbert.h"
#include "spatial/simplex_digest.h"
#include "tests/point_families.h"

namespace stream_recon {
namespace {

struct Result {
  std::size_t tetrahedra = 0;
  std::string digest;

  friend bool operator==(const Result&, const Result&) = default;
  friend std::ostream& operator<<(std::ostream& out, const Result& result) {
    return out << result.tetrahedra << " tetrahedra, digest " << result.digest;
  }
};

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Vertex = CGAL::Triangulation_vertex_base_with_info_3<std::uint32_t, Kernel>;
using Cell = CGAL::Delaunay_triangulation_cell_base_3<Kernel>;
using Oracle =
    CGAL::Delaunay_triangulation_3<Kernel, CGAL::Triangulation_data_structure_3<Vertex, Cell>>;

// Positions in the cloud along the Hilbert curve; of equal points the first alone.
std::vector<std::uint32_t> hilbert_order(const std::vector<Point3>& cloud) {
  Box3 box;
  for (const Point3& p : cloud) box.extend(p);
  const HilbertCurve curve(box);
  std::vector<std::uint64_t> keys;
  for (const Point3& p : cloud) keys.push_back(curve.key(p));
  std::vector<std::uint32_t> order(cloud.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    if (keys[a] != keys[b]) return keys[a] < keys[b];
    return cloud[a] == cloud[b] ? a < b : cloud[a] < cloud[b];
  });
  const auto end = std::unique(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    return cloud[a] == cloud[b];
  });
  order.erase(end, order.end());
  return order;
}

Result from_kernel(const std::vector<Point3>& cloud, const std::vector<std::uint32_t>& order) {
  std::vector<Point3> points;
  for (const std::uint32_t i : order) points.push_back(cloud[i]);
  Delaunay delaunay;
  EXPECT_EQ(delaunay.insert(points), Delaunay::Outcome::kDone);
  Result result;
  SimplexDigest digest;
  for (CellId c = 0; c < delaunay.cell_slots(); ++c) {
    if (!delaunay.is_live(c) || delaunay.is_infinite(c)) continue;
    const auto t = delaunay.vertices(c);
    digest.add<4>({order[t[0]], order[t[1]], order[t[2]], order[t[3]]});
    ++result.tetrahedra;
  }
  result.digest = digest.hex();
  return result;
}

Result from_oracle(const std::vector<Point3>& cloud, const std::vector<std::uint32_t>& order) {
  std::vector<std::pair<Kernel::Point_3, std::uint32_t>> points;
  for (const std::uint32_t i : order) {
    points.emplace_back(Kernel::Point_3(cloud[i].x, cloud[i].y, cloud[i].z), i);
  }
  const Oracle oracle(points.begin(), points.end());
  Result result;
  SimplexDigest digest;
  for (const auto cell : oracle.finite_cell_handles()) {
    digest.add<4>({cell->vertex(0)->info(), cell->vertex(1)->info(), cell->vertex(2)->info(),
                   cell->vertex(3)->info()});
    ++result.tetrahedra;
  }
  result.digest = digest.hex();
  return result;
}

void expect_oracle(const std::vector<Point3>& cloud) {
  const auto order = hilbert_order(cloud);
  EXPECT_EQ(from_kernel(cloud, order), from_oracle(cloud, order));
}

double gyroid(const Point3& p) {
  return std::sin(p.x) * std::cos(p.y) + std::sin(p.y) * std::cos(p.z) +
         std::sin(p.z) * std::cos(p.x);
}

// Samples of the gyroid inside a ball, by bisection between random points of different sign.
std::vector<Point3> folded_surface(int count, std::mt19937_64& random) {
  constexpr double kRadius = 12;
  std::vector<Point3> samples;
  while (static_cast<int>(samples.size()) < count) {
    const Point3 unit = families::random_point(random);
    if (unit.x * unit.x + unit.y * unit.y + unit.z * unit.z > 1) continue;
    const Point3 step = families::random_point(random);
    Point3 low{kRadius * unit.x, kRadius * unit.y, kRadius * unit.z};
    Point3 high{low.x + step.x, low.y + step.y, low.z + step.z};
    if ((gyroid(low) > 0) == (gyroid(high) > 0)) continue;
    for (int i = 0; i < 40; ++i) {
      const Point3 middle{(low.x + high.x) / 2, (low.y + high.y) / 2, (low.z + high.z) / 2};
      ((gyroid(middle) > 0) == (gyroid(low) > 0) ? low : high) = middle;
    }
    samples.push_back(low);
  }
  return samples;
}

// Lattice points next to the gyroid inside a ball, slices a multiple of the pixel spacing apart.
std::vector<Point3> lattice_shell(int radius, double pixel, int slice) {
  std::vector<Point3> shell;
  const auto inside = [&](int x, int y, int z) {
    const double scale = 12.0 / radius;
    return x * x + y * y + z * z < radius * radius && gyroid({x * scale, y * scale, z * scale}) > 0;
  };
  for (int z = -radius; z <= radius; z += slice) {
    for (int y = -radius; y <= radius; ++y) {
      for (int x = -radius; x <= radius; ++x) {
        const bool boundary = inside(x, y, z) && !(inside(x - 1, y, z) && inside(x + 1, y, z) &&
                                                   inside(x, y - 1, z) && inside(x, y + 1, z));
        if (boundary) shell.push_back({x * pixel, y * pixel, z * pixel});
      }
    }
  }
  return shell;
}

TEST(OracleDelaunay, random_points_in_a_cube) {
  const std::uint64_t seed = 21;
  SCOPED_TRACE(seed);
  std::mt19937_64 random(seed);
  std::vector<Point3> cloud;
  for (int i = 0; i < 100000; ++i) cloud.push_back(families::random_point(random));
  expect_oracle(cloud);
}

TEST(OracleDelaunay, folded_surface) {
  const std::uint64_t seed = 22;
  SCOPED_TRACE(seed);
  std::mt19937_64 random(seed);
  expect_oracle(folded_surface(100000, random));
}

TEST(OracleDelaunay, lattice_shells) {
  expect_oracle(lattice_shell(60, 1, 1));
  expect_oracle(lattice_shell(60, 1, 3));
  expect_oracle(lattice_shell(60, 0.7, 2));
}

TEST(OracleDelaunay, lattice_blocks) {
  for (const double spacing : {1.0, 0.1, 1.0 / 3}) {
    std::vector<Point3> cloud;
    for (int i = 0; i < 24 * 30 * 20; ++i) {
      cloud.push_back({spacing * (i % 24), spacing * (i / 24 % 30), spacing * (i / 720)});
    }
    SCOPED_TRACE(spacing);
    expect_oracle(cloud);
  }
}

TEST(OracleDelaunay, points_of_one_sphere) {
  const std::uint64_t seed = 23;
  SCOPED_TRACE(seed);
  std::mt19937_64 random(seed);
  std::vector<Point3> cloud;
  for (int i = 0; i < 3000; ++i) cloud.push_back(families::sphere_point(random));
  for (int i = 0; i < 20000; ++i) {
    const Point3 p = families::random_point(random);
    const double length = std::sqrt(p.x * p.x + p.y * p.y + p.z * p.z);
    cloud.push_back({p.x / length, p.y / length, p.z / length});
  }
  expect_oracle(cloud);
}

TEST(OracleDelaunay, detail_of_a_millionth_at_a_million) {
  const std::uint64_t seed = 24;
  SCOPED_TRACE(seed);
  std::mt19937_64 random(seed);
  std::vector<Point3> cloud;
  for (int i = 0; i < 30000; ++i) {
    const Point3 p = families::random_point(random);
    cloud.push_back({1e6 + 1e-5 * p.x, -1e6 + 1e-5 * p.y, 1e6 + 1e-5 * p.z});
  }
  expect_oracle(cloud);
}

std::vector<Point3> read_points(const std::string& path, std::size_t most) {
  const auto source = open_point_source(path, InputFormat::kPly);
  std::vector<Point3> cloud(most);
  std::size_t count = 0;
  while (count < most) {
    const std::size_t got = source->read(std::span(cloud).subspan(count));
    if (got == 0) break;
    count += got;
  }
  cloud.resize(count);
  return cloud;
}

struct KnownCloud {
  std::string file;
  Result result;

  friend std::ostream& operator<<(std::ostream& out, const KnownCloud& cloud) {
    return out << cloud.file << ": " << cloud.result;
  }
};

class OracleCloud : public testing::TestWithParam<KnownCloud> {};

TEST_P(OracleCloud, has_the_known_tetrahedra) {
  const std::string path = STREAM_RECON_SHARED_DATA "/clouds/" + GetParam().file;
  if (!std::filesystem::exists(path)) GTEST_SKIP() << "no shared data: " << path;
  const auto cloud = read_points(path, std::size_t{1} << 20);
  const auto order = hilbert_order(cloud);
  EXPECT_EQ(from_kernel(cloud, order), GetParam().result);
  EXPECT_EQ(from_oracle(cloud, order), GetParam().result);
}

INSTANTIATE_TEST_SUITE_P(
    Shared, OracleCloud,
    testing::Values(KnownCloud{"bunny.ply", {246227, "370c2f86a2cb7604"}},
                    KnownCloud{"armadillo.ply", {289478, "564c30cd7c984e21"}},
                    KnownCloud{"lucy.ply", {345085, "5858f4cf7b766a50"}},
                    KnownCloud{"vhf_foot_bones.ply", {1087284, "c1df91c7ae334bb8"}},
                    KnownCloud{"bunny_range_scans.ply", {2251923, "0f562720f99209c6"}}),
    [](const auto& test) { return test.param.file.substr(0, test.param.file.find('.')); });

TEST(OracleDelaunay, airborne_scan) {
  const std::string path = STREAM_RECON_SHARED_DATA "/clouds/autzen_south.ply.zst";
  if (!std::filesystem::exists(path)) GTEST_SKIP() << "no shared data: " << path;
  std::FILE* const unpacked = popen(("zstd -dcq '" + path + "'").c_str(), "r");
  ASSERT_NE(unpacked, nullptr);
  const auto cloud = read_points("/dev/fd/" + std::to_string(fileno(unpacked)), 6000000);
  pclose(unpacked);
  if (cloud.empty()) GTEST_SKIP() << "no zstd program to unpack " << path;
  expect_oracle(cloud);
}

}  // namespace
}  // namespace stream_recon
