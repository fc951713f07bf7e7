#include <gtest/gtest.h>

#include <algorithm>

#include "spatial/predicates.h"
#include "tests/exact_reference.h"
#include "tests/point_families.h"

namespace stream_recon {
namespace {

constexpr int kRounds = 1500;

using Sites = std::array<WeightedPoint3, 5>;

struct Weighting {
  std::string name;
  double (*weight)(const Point3&, std::mt19937_64&);
};

// Weights of the order of the squared distances, and weights that make everything a tie.
const std::vector<Weighting>& weightings() {
  static const std::vector<Weighting> kWeightings = {
      {"zero", [](const Point3&, std::mt19937_64&) { return 0.0; }},
      {"random", [](const Point3& p, std::mt19937_64& r) { return p.x * p.x * (r() % 100) / 64; }},
      {"steps", [](const Point3& p, std::mt19937_64& r) { return p.y * p.y * (r() % 3); }},
      {"lifted to a plane",
       [](const Point3& p, std::mt19937_64&) { return p.x * p.x + p.y * p.y + p.z * p.z; }}};
  return kWeightings;
}

template <class Check>
void for_all_families(const Check& check) {
  for (std::size_t f = 0; f < families::all().size(); ++f) {
    for (const Weighting& weighting : weightings()) {
      const std::uint64_t seed = 2000 + f;
      SCOPED_TRACE(families::all()[f].name + ", weights " + weighting.name + ", seed " +
                   std::to_string(seed));
      std::mt19937_64 random(seed);
      for (int round = 0; round < kRounds; ++round) {
        Sites sites;
        CoordinateRange range;
        for (WeightedPoint3& site : sites) {
          site.point = families::all()[f].draw(random);
          site.weight = weighting.weight(site.point, random);
          range.extend(site);
        }
        ASSERT_TRUE(range.is_safe());
        check(sites, Predicates(range));
        if (testing::Test::HasFailure()) return;
      }
    }
  }
}

bool all_distinct(Sites sites) {
  const auto below = [](const auto& a, const auto& b) { return a.point < b.point; };
  std::sort(sites.begin(), sites.end(), below);
  return std::adjacent_find(sites.begin(), sites.end(), [](const auto& a, const auto& b) {
           return a.point == b.point;
         }) == sites.end();
}

int orient(const Predicates& predicates, const WeightedPoint3& a, const WeightedPoint3& b,
           const WeightedPoint3& c, const WeightedPoint3& d) {
  return predicates.orient3d(a.point, b.point, c.point, d.point);
}

TEST(PowerTest, a_heavy_site_far_away_is_in_conflict) {
  const Sites s{{{{0, 0, 0}, 0}, {{1, 0, 0}, 0}, {{0, 1, 0}, 0}, {{0, 0, 1}, 0}, {{3, 3, 3}, 0}}};
  CoordinateRange range;
  for (const auto& site : s) range.extend(site);
  const Predicates predicates(range);
  EXPECT_EQ(predicates.power_test(s[0], s[1], s[2], s[3], {{3, 3, 3}, 0}), -1);
  EXPECT_EQ(predicates.power_test(s[0], s[1], s[2], s[3], {{3, 3, 3}, 18}), 0);
  EXPECT_EQ(predicates.power_test(s[0], s[1], s[2], s[3], {{3, 3, 3}, 19}), 1);
}

TEST(PowerTest, is_exact_on_every_family) {
  for_all_families([](const Sites& s, const Predicates& predicates) {
    EXPECT_EQ(predicates.power_test(s[0], s[1], s[2], s[3], s[4]), reference::power_test(s));
  });
}

TEST(PowerTest, is_the_sphere_test_for_equal_weights) {
  for_all_families([](Sites s, const Predicates& predicates) {
    for (WeightedPoint3& site : s) site.weight = s[0].weight;
    EXPECT_EQ(predicates.power_test(s[0], s[1], s[2], s[3], s[4]),
              predicates.in_sphere(s[0].point, s[1].point, s[2].point, s[3].point, s[4].point));
  });
}

TEST(PowerTest, in_a_plane_is_exact) {
  for_all_families([](Sites s, const Predicates& predicates) {
    for (WeightedPoint3& site : s) site.point.x = s[0].point.x;
    if (predicates.coplanar_orientation(s[0].point, s[1].point, s[2].point) == 0) return;
    EXPECT_EQ(predicates.power_circle(s[0], s[1], s[2], s[3]),
              reference::power_circle({s[0], s[1], s[2], s[3]}));
  });
}

TEST(PowerTest, perturbed_is_never_zero_and_symmetric_across_a_facet) {
  for_all_families([](Sites s, const Predicates& predicates) {
    if (!all_distinct(s)) return;
    if (orient(predicates, s[0], s[1], s[2], s[3]) < 0) std::swap(s[0], s[1]);
    if (orient(predicates, s[0], s[1], s[2], s[3]) == 0) return;
    const int sign = predicates.power_test_perturbed(s[0], s[1], s[2], s[3], s[4]);
    EXPECT_NE(sign, 0);
    EXPECT_EQ(predicates.power_test_perturbed(s[1], s[2], s[0], s[3], s[4]), sign);
    if (orient(predicates, s[1], s[0], s[2], s[4]) > 0) {
      EXPECT_EQ(predicates.power_test_perturbed(s[1], s[0], s[2], s[4], s[3]), sign);
    }
  });
}

TEST(PowerTest, perturbed_in_a_plane_is_never_zero) {
  for_all_families([](Sites s, const Predicates& predicates) {
    for (WeightedPoint3& site : s) site.point.y = s[0].point.y;
    if (!all_distinct(s)) return;
    if (predicates.coplanar_orientation(s[0].point, s[1].point, s[2].point) == 0) return;
    const int sign = predicates.power_circle_perturbed(s[0], s[1], s[2], s[3]);
    EXPECT_NE(sign, 0);
    EXPECT_EQ(predicates.power_circle_perturbed(s[1], s[0], s[2], s[3]), sign);
  });
}

}  // namespace
}  // namespace stream_recon
