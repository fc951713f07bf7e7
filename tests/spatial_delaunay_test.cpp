#include "spatial/delaunay.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <random>

#include "tests/delaunay_check.h"
#include "tests/point_families.h"

namespace stream_recon {
namespace {

using delaunay_check::brute_force;
using delaunay_check::expect_valid;
using delaunay_check::tetrahedra;
using Outcome = Delaunay::Outcome;

// Up to `count` distinct points, fewer where the family has not so many.
std::vector<Point3> draw_distinct(Point3 (*draw)(std::mt19937_64&), int count,
                                  std::mt19937_64& random) {
  std::set<Point3> seen;
  std::vector<Point3> points;
  for (int tries = 0; tries < 20 * count && static_cast<int>(points.size()) < count; ++tries) {
    const Point3 p = draw(random);
    if (seen.insert(p).second) points.push_back(p);
  }
  return points;
}

std::vector<Point3> block(int nx, int ny, int nz, double spacing) {
  std::vector<Point3> points;
  for (int z = 0; z < nz; ++z) {
    for (int y = 0; y < ny; ++y) {
      for (int x = 0; x < nx; ++x) points.push_back({x * spacing, y * spacing, z * spacing});
    }
  }
  return points;
}

void expect_brute_force(const std::vector<Point3>& points) {
  Delaunay delaunay;
  const Outcome outcome = delaunay.insert(points);
  const auto expected = brute_force(points);
  if (expected.empty()) {
    EXPECT_EQ(outcome, Outcome::kFlat);
    EXPECT_LT(delaunay.dimension(), 3);
    return;
  }
  ASSERT_EQ(outcome, Outcome::kDone);
  EXPECT_EQ(delaunay.dimension(), 3);
  EXPECT_EQ(tetrahedra(delaunay), expected);
  expect_valid(delaunay, points);
}

void expect_valid_after_insert(const std::vector<Point3>& points) {
  Delaunay delaunay;
  ASSERT_EQ(delaunay.insert(points), Outcome::kDone);
  expect_valid(delaunay, points);
}

TEST(Delaunay, equals_brute_force_on_few_points_of_every_family) {
  for (std::size_t f = 0; f < families::all().size(); ++f) {
    for (int count = 1; count <= 14; ++count) {
      const std::uint64_t seed = 100 * f + count;
      SCOPED_TRACE(families::all()[f].name + ", seed " + std::to_string(seed));
      std::mt19937_64 random(seed);
      ASSERT_NO_FATAL_FAILURE(
          expect_brute_force(draw_distinct(families::all()[f].draw, count, random)));
    }
  }
}

TEST(Delaunay, equals_brute_force_on_cube_corners_and_prism_stacks) {
  expect_brute_force(block(2, 2, 2, 1));
  expect_brute_force(block(2, 2, 5, 1));
  expect_brute_force(block(3, 3, 2, 0.3));
  std::vector<Point3> prisms;
  for (int layer = 0; layer < 4; ++layer) {
    for (const auto& [x, y] : {std::pair{0.0, 0.0}, {4.0, 0.0}, {1.0, 3.0}, {3.0, 3.0}}) {
      prisms.push_back({x, y, 2.0 * layer});
    }
  }
  expect_brute_force(prisms);
}

TEST(Delaunay, is_valid_on_many_points_of_every_family) {
  for (std::size_t f = 0; f < families::all().size(); ++f) {
    const std::uint64_t seed = 77 + f;
    SCOPED_TRACE(families::all()[f].name + ", seed " + std::to_string(seed));
    std::mt19937_64 random(seed);
    const auto points = draw_distinct(families::all()[f].draw, 1500, random);
    if (families::all()[f].name == "coplanar") {
      Delaunay delaunay;
      EXPECT_EQ(delaunay.insert(points), Outcome::kFlat);
      continue;
    }
    ASSERT_NO_FATAL_FAILURE(expect_valid_after_insert(points));
  }
}

TEST(Delaunay, is_valid_on_lattice_blocks) {
  expect_valid_after_insert(block(12, 12, 12, 1));
  expect_valid_after_insert(block(40, 40, 2, 0.7));
  expect_valid_after_insert(block(2, 2, 400, 1e-3));
}

TEST(Delaunay, knows_the_dimension_of_flat_clouds) {
  Delaunay delaunay;
  EXPECT_EQ(delaunay.insert({}), Outcome::kFlat);
  EXPECT_EQ(delaunay.dimension(), -1);
  const std::array<Point3, 1> one{{{5, 5, 5}}};
  EXPECT_EQ(delaunay.insert(one), Outcome::kFlat);
  EXPECT_EQ(delaunay.dimension(), 0);
  const std::array<Point3, 3> collinear{{{6, 7, 8}, {3, 1, -1}, {4, 3, 2}}};
  EXPECT_EQ(delaunay.insert(collinear), Outcome::kFlat);
  EXPECT_EQ(delaunay.dimension(), 1);
  const std::array<Point3, 2> coplanar{{{5, 0, 0}, {5, -5, -5}}};
  EXPECT_EQ(delaunay.insert(coplanar), Outcome::kFlat);
  EXPECT_EQ(delaunay.dimension(), 2);
  EXPECT_EQ(delaunay.finite_cell_count(), 0U);
}

TEST(Delaunay, flat_beginnings_are_not_lost_when_space_opens) {
  for (const int line : {1, 2, 30}) {
    for (const int plane : {1, 2, 30}) {
      std::vector<Point3> points;
      Delaunay delaunay;
      const auto insert = [&](const Point3& p) {
        points.push_back(p);
        return delaunay.insert({&p, 1});
      };
      for (int i = 0; i < line; ++i) ASSERT_EQ(insert({i * 1.0, 0, 0}), Outcome::kFlat);
      for (int i = 0; i < plane; ++i)
        ASSERT_EQ(insert({i % 6 * 1.0, 1.0 + i / 6, 0}), Outcome::kFlat);
      if (line + plane < 3) continue;
      ASSERT_EQ(insert({0.5, 0.5, 2}), Outcome::kDone) << line << " " << plane;
      ASSERT_EQ(insert({0.5, 0.5, -2}), Outcome::kDone);
      expect_valid(delaunay, points);
    }
  }
}

TEST(Delaunay, does_not_depend_on_the_order_of_insertion) {
  for (std::size_t f = 0; f < families::all().size(); ++f) {
    const std::uint64_t seed = 500 + f;
    SCOPED_TRACE(families::all()[f].name + ", seed " + std::to_string(seed));
    std::mt19937_64 random(seed);
    const auto points = draw_distinct(families::all()[f].draw, 400, random);
    Delaunay straight;
    const Outcome outcome = straight.insert(points);
    std::vector<VertexId> order(points.size());
    std::iota(order.begin(), order.end(), 0);
    for (int round = 0; round < 3; ++round) {
      std::shuffle(order.begin(), order.end(), random);
      std::vector<Point3> shuffled;
      for (const VertexId v : order) shuffled.push_back(points[v]);
      Delaunay other;
      ASSERT_EQ(other.insert(shuffled), outcome);
      EXPECT_EQ(tetrahedra(other, order), tetrahedra(straight));
    }
  }
}

TEST(Delaunay, does_not_depend_on_batches) {
  for (std::size_t f = 0; f < families::all().size(); ++f) {
    const std::uint64_t seed = 900 + f;
    SCOPED_TRACE(families::all()[f].name + ", seed " + std::to_string(seed));
    std::mt19937_64 random(seed);
    const auto points = draw_distinct(families::all()[f].draw, 400, random);
    Delaunay whole;
    const Outcome outcome = whole.insert(points);
    Delaunay parts;
    Outcome last = Outcome::kFlat;
    for (std::size_t done = 0; done < points.size();) {
      const std::size_t size = std::min<std::size_t>(1 + random() % 60, points.size() - done);
      last = parts.insert(std::span(points).subspan(done, size));
      done += size;
      if (last == Outcome::kDone && done < points.size() / 2) {
        expect_valid(parts, {points.begin(), points.begin() + static_cast<std::ptrdiff_t>(done)});
      }
    }
    ASSERT_EQ(last, outcome);
    EXPECT_EQ(tetrahedra(parts), tetrahedra(whole));
  }
}

TEST(Delaunay, keeps_points_as_they_are_in_their_order) {
  std::mt19937_64 random(3);
  const auto points = draw_distinct(families::random_point, 500, random);
  Delaunay delaunay;
  ASSERT_EQ(delaunay.insert(points), Outcome::kDone);
  for (VertexId v = 0; v < points.size(); ++v) EXPECT_EQ(delaunay.point(v), points[v]);
}

TEST(Delaunay, works_on_denormals_and_giants) {
  for (const int exponent : {-1074, -1060, -800, 700, 1000, 1016}) {
    SCOPED_TRACE(exponent);
    std::mt19937_64 random(9);
    auto points = draw_distinct(
        [](std::mt19937_64& r) { return families::lattice_point(r, 40, 1); }, 300, random);
    for (Point3& p : points) {
      p = {std::ldexp(p.x, exponent), std::ldexp(p.y, exponent), std::ldexp(p.z, exponent)};
    }
    Delaunay delaunay;
    ASSERT_EQ(delaunay.insert(points), Outcome::kDone);
    expect_valid(delaunay, points);
    for (VertexId v = 0; v < points.size(); ++v) ASSERT_EQ(delaunay.point(v), points[v]);
  }
}

TEST(Delaunay, refuses_magnitudes_beyond_exact_arithmetic) {
  const std::array<Point3, 5> points{{{1e-300, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}}};
  Delaunay delaunay;
  EXPECT_EQ(delaunay.insert(points), Outcome::kBadRange);
}

TEST(Delaunay, stops_at_its_memory_limit) {
  std::mt19937_64 random(4);
  const auto points = draw_distinct(families::random_point, 20000, random);
  Delaunay limited(Delaunay::Options{.max_bytes = 1 << 20, .range = {}});
  EXPECT_EQ(limited.insert(points), Outcome::kOutgrown);
  EXPECT_LE(limited.bytes(), std::size_t{1} << 20);
}

TEST(Delaunay, takes_at_most_three_hundred_bytes_a_point) {
  std::mt19937_64 random(5);
  const auto points = draw_distinct(families::random_point, 30000, random);
  Delaunay delaunay;
  ASSERT_EQ(delaunay.insert(points), Outcome::kDone);
  EXPECT_LE(delaunay.bytes(), 300 * points.size());
}

TEST(Delaunay, moving_keeps_the_structure) {
  const auto points = block(4, 4, 4, 1);
  Delaunay first;
  ASSERT_EQ(first.insert(points), Outcome::kDone);
  Delaunay second = std::move(first);
  expect_valid(second, points);
  first = Delaunay();
  EXPECT_EQ(first.dimension(), -1);
}

}  // namespace
}  // namespace stream_recon
