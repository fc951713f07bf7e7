// The kernel's regular triangulations are those of CGAL, ties included.
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Regular_triangulation_3.h>
#include <CGAL/Regular_triangulation_cell_base_3.h>
#include <CGAL/Regular_triangulation_vertex_base_3.h>
#include <CGAL/Triangulation_vertex_base_with_info_3.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <map>
#include <ostream>
#include <random>
#include <vector>

#include "io/point_source.h"
#include "spatial/regular_triangulation.h"
#include "spatial/simplex_digest.h"
#include "tests/point_families.h"
#include "tools/kernel_bench/kernel_bench.h"

namespace stream_recon {
namespace {

using Sites = std::vector<WeightedPoint3>;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Vertex =
    CGAL::Triangulation_vertex_base_with_info_3<std::uint32_t, Kernel,
                                                CGAL::Regular_triangulation_vertex_base_3<Kernel>>;
using Cell = CGAL::Regular_triangulation_cell_base_3<Kernel>;
using Oracle =
    CGAL::Regular_triangulation_3<Kernel, CGAL::Triangulation_data_structure_3<Vertex, Cell>>;

struct Result {
  std::size_t tetrahedra = 0;
  std::size_t hidden = 0;
  std::string digest;

  friend bool operator==(const Result&, const Result&) = default;
  friend std::ostream& operator<<(std::ostream& out, const Result& result) {
    return out << result.tetrahedra << " tetrahedra, " << result.hidden << " hidden, digest "
               << result.digest;
  }
};

Result from_kernel(const Sites& sites) {
  RegularTriangulation regular;
  EXPECT_EQ(regular.insert(sites), RegularTriangulation::Outcome::kDone);
  Result result{regular.finite_cell_count(), regular.hidden_count(), {}};
  SimplexDigest digest;
  for (CellId c = 0; c < regular.cell_slots(); ++c) {
    if (!regular.is_live(c) || regular.is_infinite(c)) continue;
    const auto t = regular.vertices(c);
    digest.add<4>({t[0], t[1], t[2], t[3]});
  }
  result.digest = digest.hex();
  return result;
}

// The oracle loses an equal site without a word; it goes first, so that the first index stays.
Result from_oracle(const Sites& sites) {
  std::map<std::pair<Point3, double>, std::uint32_t> first;
  std::vector<std::pair<Kernel::Weighted_point_3, std::uint32_t>> distinct;
  for (std::uint32_t i = 0; i < sites.size(); ++i) {
    const auto& [p, weight] = sites[i];
    if (!first.insert({{p, weight}, i}).second) continue;
    distinct.emplace_back(Kernel::Weighted_point_3(Kernel::Point_3(p.x, p.y, p.z), weight), i);
  }
  const Oracle oracle(distinct.begin(), distinct.end());
  Result result{oracle.number_of_finite_cells(), sites.size() - oracle.number_of_vertices(), {}};
  SimplexDigest digest;
  for (const auto cell : oracle.finite_cell_handles()) {
    digest.add<4>({cell->vertex(0)->info(), cell->vertex(1)->info(), cell->vertex(2)->info(),
                   cell->vertex(3)->info()});
  }
  result.digest = digest.hex();
  return result;
}

void expect_oracle(const Sites& sites) {
  EXPECT_EQ(from_kernel(sites), from_oracle(sites));
}

// Weights uniform up to `heaviest`, of sites in a cube of side 2.
Sites random_sites(int count, double heaviest) {
  std::mt19937_64 random(41);
  std::uniform_real_distribution<double> weight(0, heaviest);
  Sites sites;
  for (int i = 0; i < count; ++i) sites.push_back({families::random_point(random), weight(random)});
  return sites;
}

Sites lattice_sites(double spacing, int heaviest) {
  std::mt19937_64 random(42);
  Sites sites;
  for (int i = 0; i < 14 * 15 * 16; ++i) {
    const Point3 p{spacing * (i % 14), spacing * (i / 14 % 15), spacing * (i / 210)};
    sites.push_back({p, spacing * spacing * double(random() % heaviest)});
  }
  std::shuffle(sites.begin(), sites.end(), random);
  return sites;
}

TEST(OracleRegular, random_weights) {
  expect_oracle(random_sites(20000, 0.001));
}

TEST(OracleRegular, sets_rich_in_hidden_sites) {
  for (const double heaviest : {0.01, 0.1, 1.0}) {
    const Sites sites = random_sites(20000, heaviest);
    SCOPED_TRACE(heaviest);
    EXPECT_GT(from_kernel(sites).hidden, 10000u * (heaviest >= 0.1 ? 1 : 0));
    expect_oracle(sites);
  }
}

TEST(OracleRegular, lattices_with_equal_and_with_whole_weights) {
  for (const double spacing : {1.0, 0.1}) {
    for (const int heaviest : {1, 2, 3, 8}) {
      SCOPED_TRACE(std::to_string(spacing) + ", weights below " + std::to_string(heaviest));
      expect_oracle(lattice_sites(spacing, heaviest));
    }
  }
}

TEST(OracleRegular, lattices_lifted_to_a_plane) {
  Sites sites = lattice_sites(1, 1);
  for (auto& [p, weight] : sites) weight = p.x * p.x + p.y * p.y + p.z * p.z;
  expect_oracle(sites);
}

TEST(OracleRegular, several_sites_at_one_place) {
  std::mt19937_64 random(43);
  Sites sites;
  for (int i = 0; i < 6000; ++i)
    sites.push_back({families::lattice_point(random, 6, 0.5), 0.25 * double(random() % 3)});
  expect_oracle(sites);
}

// What a power crust triangulates: all balls pass through samples, so that nearly every test is
// a near tie.
class OraclePoles : public testing::TestWithParam<const char*> {};

TEST_P(OraclePoles, of_a_real_cloud) {
  const std::string path = std::string(STREAM_RECON_SHARED_DATA "/clouds/") + GetParam() + ".ply";
  if (!std::filesystem::exists(path)) GTEST_SKIP() << "no shared data: " << path;
  const auto source = open_point_source(path, InputFormat::kAuto);
  const PoleCloud poles = find_poles(read_distinct_points(*source));
  EXPECT_GT(poles.sites.size(), 30000u);
  expect_oracle(poles.sites);
}

INSTANTIATE_TEST_SUITE_P(Clouds, OraclePoles, testing::Values("bunny", "armadillo", "lucy"));

TEST(OracleRegular, poles_of_a_lattice_shell) {
  DistinctPoints cloud;
  for (int x = -20; x <= 20; ++x) {
    for (int y = -20; y <= 20; ++y) {
      for (int z = -20; z <= 20; z += 2) {
        const int square = x * x + y * y + z * z;
        if (square > 324 && square <= 361) cloud.points.push_back({1.0 * x, 1.0 * y, 1.0 * z});
      }
    }
  }
  const PoleCloud poles = find_poles(cloud);
  EXPECT_GT(poles.sites.size(), 500u);
  expect_oracle(poles.sites);
}

}  // namespace
}  // namespace stream_recon
