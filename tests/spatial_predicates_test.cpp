#include "spatial/predicates.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "spatial/predicates_exact.h"
#include "tests/exact_reference.h"
#include "tests/point_families.h"

namespace stream_recon {
namespace {

constexpr int kRounds = 4000;

using Points5 = std::array<Point3, 5>;

template <class Points>
Predicates predicates_of(const Points& points) {
  CoordinateRange range;
  for (const auto& p : points) range.extend(p);
  EXPECT_TRUE(range.is_safe());
  return Predicates(range);
}

// Calls check(points, random) for many draws from every family of points.
template <class Check>
void for_all_families(const Check& check) {
  for (std::size_t f = 0; f < families::all().size(); ++f) {
    const auto& family = families::all()[f];
    const std::uint64_t seed = 1000 + f;
    SCOPED_TRACE(family.name + ", seed " + std::to_string(seed));
    std::mt19937_64 random(seed);
    for (int round = 0; round < kRounds; ++round) {
      Points5 points;
      for (Point3& p : points) p = family.draw(random);
      check(points, random);
      if (testing::Test::HasFailure()) return;
    }
  }
}

bool all_distinct(Points5 points) {
  std::sort(points.begin(), points.end());
  return std::adjacent_find(points.begin(), points.end()) == points.end();
}

TEST(Predicates, orient3d_is_positive_for_the_unit_corner) {
  const std::array<Point3, 4> p{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  EXPECT_EQ(predicates_of(p).orient3d(p[0], p[1], p[2], p[3]), 1);
}

TEST(Predicates, in_sphere_tells_inside_from_outside_of_the_unit_corner) {
  const Points5 p{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}}};
  const Predicates predicates = predicates_of(p);
  EXPECT_EQ(predicates.in_sphere(p[0], p[1], p[2], p[3], {0.5, 0.5, 0.5}), 1);
  EXPECT_EQ(predicates.in_sphere(p[0], p[1], p[2], p[3], {2, 1, 1}), -1);
  EXPECT_EQ(predicates.in_sphere(p[0], p[1], p[2], p[3], {1, 1, 1}), 0);
}

TEST(Predicates, orient3d_is_exact_on_every_family) {
  for_all_families([](const Points5& p, auto&) {
    EXPECT_EQ(predicates_of(p).orient3d(p[0], p[1], p[2], p[3]),
              reference::orient3d(p[0], p[1], p[2], p[3]));
  });
}

TEST(Predicates, in_sphere_is_exact_on_every_family) {
  for_all_families([](const Points5& p, auto&) {
    EXPECT_EQ(predicates_of(p).in_sphere(p[0], p[1], p[2], p[3], p[4]),
              reference::in_sphere(p[0], p[1], p[2], p[3], p[4]));
  });
}

TEST(Predicates, filter_is_never_certain_of_a_wrong_sign) {
  for_all_families([](const Points5& p, auto&) {
    const Estimate sphere = estimate_in_sphere(difference(p[0], p[4]), difference(p[1], p[4]),
                                               difference(p[2], p[4]), difference(p[3], p[4]));
    if (sphere.is_certain()) {
      EXPECT_EQ(sphere.sign(), reference::in_sphere(p[0], p[1], p[2], p[3], p[4]));
    }
    const Estimate plane = estimate_determinant(difference(p[1], p[0]), difference(p[2], p[0]),
                                                difference(p[3], p[0]));
    if (plane.is_certain()) {
      EXPECT_EQ(plane.sign(), reference::orient3d(p[0], p[1], p[2], p[3]));
    }
  });
}

TEST(Predicates, last_rung_is_exact_on_its_own) {
  for_all_families([&](const Points5& p, auto&) {
    EXPECT_EQ(detail::exact_in_sphere(p), reference::in_sphere(p[0], p[1], p[2], p[3], p[4]));
    EXPECT_EQ(detail::exact_power_test({{{p[0], 0}, {p[1], 0}, {p[2], 0}, {p[3], 0}, {p[4], 0}}}),
              detail::exact_in_sphere(p));
    EXPECT_EQ(detail::exact_orient3d(p[0], p[1], p[2], p[3]),
              reference::orient3d(p[0], p[1], p[2], p[3]));
  });
}

TEST(Predicates, lattice_rung_is_exact_up_to_its_reach) {
  const std::uint64_t seed = 6;
  SCOPED_TRACE(seed);
  std::mt19937_64 random(seed);
  for (int round = 0; round < 20 * kRounds; ++round) {
    Points5 p;
    // The first point at the origin, so that differences are at most 655.
    for (int i = 0; i < 4; ++i) p[i] = families::lattice_point(random, 655, 1);
    p[4] = {};
    const Estimate estimate = estimate_in_sphere(p[0], p[1], p[2], p[3]);
    ASSERT_EQ(estimate.sign(), reference::in_sphere(p[0], p[1], p[2], p[3], p[4]));
  }
}

TEST(Predicates, differences_rounded_to_two_to_the_53_units_are_not_taken_for_exact) {
  const double below_one = 1 - 0x1p-53;
  const std::array<Point3, 4> p{{{-2, 0x1p-53, 1},
                                 {-below_one, -below_one, -0x1p-53},
                                 {-below_one, -below_one, 0},
                                 {-1, -1, 1}}};
  EXPECT_EQ(predicates_of(p).orient3d(p[0], p[1], p[2], p[3]), 1);
}

TEST(Predicates, in_circle_is_exact_on_coplanar_points) {
  for_all_families([](Points5 p, auto&) {
    if (reference::orient3d(p[0], p[1], p[2], p[3]) != 0) {
      for (Point3& q : p) q.z = p[0].z;
    }
    const Predicates predicates = predicates_of(p);
    if (predicates.coplanar_orientation(p[0], p[1], p[2]) == 0) return;
    EXPECT_EQ(predicates.in_circle(p[0], p[1], p[2], p[3]),
              reference::power_circle({{{p[0], 0}, {p[1], 0}, {p[2], 0}, {p[3], 0}}}));
    EXPECT_EQ(predicates.in_circle(p[0], p[1], p[2], p[3]),
              predicates.in_circle(p[1], p[0], p[2], p[3]));
  });
}

TEST(Predicates, coplanar_orientation_is_zero_for_collinear_points_only) {
  for_all_families([](const Points5& p, auto&) {
    const auto u = reference::minus(reference::to_vector(p[1]), reference::to_vector(p[0]));
    const auto v = reference::minus(reference::to_vector(p[2]), reference::to_vector(p[0]));
    const bool collinear = reference::cross(u, v) == reference::Vector{0, 0, 0};
    EXPECT_EQ(predicates_of(p).coplanar_orientation(p[0], p[1], p[2]) == 0, collinear);
  });
}

TEST(Predicates, signs_alternate_under_permutations) {
  for_all_families([](Points5 p, auto& random) {
    const Predicates predicates = predicates_of(p);
    const int sphere = predicates.in_sphere(p[0], p[1], p[2], p[3], p[4]);
    const int orientation = predicates.orient3d(p[0], p[1], p[2], p[3]);
    const auto i = random() % 4;
    const auto j = (i + 1 + random() % 3) % 4;
    std::swap(p[i], p[j]);
    EXPECT_EQ(predicates.in_sphere(p[0], p[1], p[2], p[3], p[4]), -sphere);
    EXPECT_EQ(predicates.orient3d(p[0], p[1], p[2], p[3]), -orientation);
  });
}

TEST(Predicates, perturbed_in_sphere_is_never_zero_and_the_same_for_even_permutations) {
  for_all_families([](Points5 p, auto&) {
    const Predicates predicates = predicates_of(p);
    if (!all_distinct(p)) return;
    const int orientation = predicates.orient3d(p[0], p[1], p[2], p[3]);
    if (orientation == 0) return;
    if (orientation < 0) std::swap(p[0], p[1]);
    const int sign = predicates.in_sphere_perturbed(p[0], p[1], p[2], p[3], p[4]);
    const int exact = predicates.in_sphere(p[0], p[1], p[2], p[3], p[4]);
    EXPECT_NE(sign, 0);
    if (exact != 0) {
      EXPECT_EQ(sign, exact);
    }
    EXPECT_EQ(predicates.in_sphere_perturbed(p[1], p[2], p[0], p[3], p[4]), sign);
    EXPECT_EQ(predicates.in_sphere_perturbed(p[3], p[2], p[1], p[0], p[4]), sign);
  });
}

TEST(Predicates, lattice_ties_are_decided_like_all_others) {
  const std::uint64_t seed = 5;
  SCOPED_TRACE(seed);
  std::mt19937_64 random(seed);
  int ties = 0;
  for (int round = 0; round < 100 * kRounds; ++round) {
    Points5 p;
    for (Point3& q : p) q = families::lattice_point(random, 1 + round % 2, 0.5);
    const Predicates predicates = predicates_of(p);
    if (!all_distinct(p) || predicates.orient3d(p[0], p[1], p[2], p[3]) <= 0) continue;
    if (predicates.in_sphere(p[0], p[1], p[2], p[3], p[4]) != 0) continue;
    ++ties;
    const int tie = decide_tie<4>({&p[0], &p[1], &p[2], &p[3]}, p[4], [&](const auto& q) {
      return reference::orient3d(*q[0], *q[1], *q[2], *q[3]);
    });
    ASSERT_EQ(predicates.in_sphere_perturbed(p[0], p[1], p[2], p[3], p[4]), tie);
  }
  EXPECT_GT(ties, kRounds);
}

// Of two tetrahedra on a common facet each says of the other's apex the same: both locally
// Delaunay or both not.
TEST(Predicates, perturbed_in_sphere_is_symmetric_across_a_facet) {
  for_all_families([](Points5 p, auto&) {
    const Predicates predicates = predicates_of(p);
    if (!all_distinct(p)) return;
    if (predicates.orient3d(p[0], p[1], p[2], p[3]) < 0) std::swap(p[0], p[1]);
    if (predicates.orient3d(p[0], p[1], p[2], p[3]) <= 0) return;
    if (predicates.orient3d(p[1], p[0], p[2], p[4]) <= 0) return;
    EXPECT_EQ(predicates.in_sphere_perturbed(p[0], p[1], p[2], p[3], p[4]),
              predicates.in_sphere_perturbed(p[1], p[0], p[2], p[4], p[3]));
  });
}

TEST(Predicates, perturbed_in_circle_is_never_zero_and_symmetric_across_an_edge) {
  for_all_families([](Points5 p, auto&) {
    for (Point3& q : p) q.z = p[0].z;
    const Predicates predicates = predicates_of(p);
    if (!all_distinct(p)) return;
    const int left = predicates.coplanar_orientation(p[0], p[1], p[2]);
    const int right = predicates.coplanar_orientation(p[0], p[1], p[3]);
    if (left == 0) return;
    const int sign = predicates.in_circle_perturbed(p[0], p[1], p[2], p[3]);
    EXPECT_NE(sign, 0);
    EXPECT_EQ(predicates.in_circle_perturbed(p[2], p[0], p[1], p[3]), sign);
    EXPECT_EQ(predicates.in_circle_perturbed(p[1], p[0], p[2], p[3]), sign);
    if (left * right < 0) {
      EXPECT_EQ(predicates.in_circle_perturbed(p[1], p[0], p[3], p[2]), sign);
    }
  });
}

}  // namespace
}  // namespace stream_recon
