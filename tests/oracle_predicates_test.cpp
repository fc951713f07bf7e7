// The perturbation is the one of CGAL: its triangulations of lattices satisfy our tests.
#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Regular_triangulation_3.h>
#include <gtest/gtest.h>

#include <random>
#include <vector>

#include "spatial/predicates.h"
#include "tests/point_families.h"

namespace stream_recon {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Oracle = CGAL::Delaunay_triangulation_3<Kernel>;
using WeightedOracle = CGAL::Regular_triangulation_3<Kernel>;

WeightedPoint3 from(const Kernel::Point_3& p) {
  return {{p.x(), p.y(), p.z()}, 0};
}
WeightedPoint3 from(const Kernel::Weighted_point_3& p) {
  return {{p.x(), p.y(), p.z()}, p.weight()};
}

// Whether the perturbed site q is in conflict with a cell of the oracle.
template <class Triangulation>
int conflict(const Triangulation& oracle, const Predicates& predicates,
             typename Triangulation::Cell_handle cell, const WeightedPoint3& q) {
  std::array<WeightedPoint3, 4> s;
  int infinite = -1;
  for (int i = 0; i < 4; ++i) {
    if (oracle.is_infinite(cell->vertex(i))) {
      infinite = i;
    } else {
      s[i] = from(cell->vertex(i)->point());
    }
  }
  if (infinite < 0) return predicates.power_test_perturbed(s[0], s[1], s[2], s[3], q);
  s[infinite] = q;
  const int side = predicates.orient3d(s[0].point, s[1].point, s[2].point, s[3].point);
  if (side != 0) return side;
  std::rotate(s.begin(), s.begin() + infinite, s.end());
  return predicates.power_circle_perturbed(s[1], s[2], s[3], q);
}

// Counts the cells in conflict with the vertex across one of their facets.
template <class Triangulation>
int count_conflicts(const Triangulation& oracle) {
  CoordinateRange range;
  for (auto v : oracle.finite_vertex_handles()) range.extend(from(v->point()));
  const Predicates predicates(range);
  int conflicts = 0;
  for (auto cell : oracle.all_cell_handles()) {
    for (int i = 0; i < 4; ++i) {
      const auto across = oracle.mirror_vertex(cell, i);
      if (oracle.is_infinite(across)) continue;
      conflicts += conflict(oracle, predicates, cell, from(across->point())) > 0;
    }
  }
  return conflicts;
}

std::vector<Kernel::Point_3> block(int nx, int ny, int nz, double spacing) {
  std::vector<Kernel::Point_3> points;
  for (int i = 0; i < nx * ny * nz; ++i) {
    points.emplace_back(spacing * (i % nx), spacing * (i / nx % ny), spacing * (i / (nx * ny)));
  }
  return points;
}

TEST(OraclePredicates, delaunay_of_lattice_blocks_has_no_conflicts) {
  for (const double spacing : {1.0, 0.7, 1000.0}) {
    for (const auto& points : {block(5, 5, 5, spacing), block(9, 4, 2, spacing),
                               block(2, 2, 2, spacing), block(12, 12, 3, spacing)}) {
      const Oracle oracle(points.begin(), points.end());
      ASSERT_EQ(oracle.dimension(), 3);
      EXPECT_EQ(count_conflicts(oracle), 0) << points.size() << " points, spacing " << spacing;
    }
  }
}

TEST(OraclePredicates, delaunay_of_cospherical_points_has_no_conflicts) {
  std::mt19937_64 random(11);
  std::vector<Kernel::Point_3> points;
  for (int i = 0; i < 400; ++i) {
    const Point3 p = families::sphere_point(random);
    points.emplace_back(p.x, p.y, p.z);
  }
  EXPECT_EQ(count_conflicts(Oracle(points.begin(), points.end())), 0);
}

TEST(OraclePredicates, regular_triangulation_of_weighted_lattices_has_no_conflicts) {
  std::mt19937_64 random(12);
  for (const int heaviest : {1, 2, 4}) {
    std::vector<Kernel::Weighted_point_3> points;
    for (const auto& p : block(7, 6, 5, 1)) points.emplace_back(p, double(random() % heaviest));
    const WeightedOracle oracle(points.begin(), points.end());
    ASSERT_EQ(oracle.dimension(), 3);
    EXPECT_EQ(count_conflicts(oracle), 0) << "weights below " << heaviest;
  }
}

}  // namespace
}  // namespace stream_recon
