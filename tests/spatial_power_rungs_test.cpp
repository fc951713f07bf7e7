// Each rung of the power tests against the next: four lanes, doubles, wide integers, integers of
// unlimited size.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <random>
#include <string>
#include <vector>

#include "spatial/power_batch.h"
#include "spatial/power_filter.h"
#include "spatial/predicates.h"
#include "spatial/predicates_exact.h"
#include "tests/exact_reference.h"
#include "tests/point_families.h"

namespace stream_recon {
namespace {

using detail::Cell;
using Sites = std::vector<WeightedPoint3>;

double square(const Point3& p) {
  return p.x * p.x + p.y * p.y + p.z * p.z;
}

struct Kind {
  std::string name;
  WeightedPoint3 (*draw)(std::mt19937_64&);
};

// The balls of `through_origin` all pass through the origin, as the balls of poles pass through a
// sample: every power test is nearly zero.
const std::vector<Kind>& kinds() {
  static const std::vector<Kind> all = {
      {"random",
       [](std::mt19937_64& r) {
         return WeightedPoint3{families::random_point(r), std::ldexp(double(r() % 1000), -10)};
       }},
      {"lattice",
       [](std::mt19937_64& r) {
         return WeightedPoint3{families::lattice_point(r, 3, 0.5), double(r() % 5)};
       }},
      {"wide_lattice",
       [](std::mt19937_64& r) {
         return WeightedPoint3{families::lattice_point(r, 340, 1), double(r() % 500000)};
       }},
      {"heavy_lattice",
       [](std::mt19937_64& r) {
         return WeightedPoint3{families::lattice_point(r, 3, 1), std::ldexp(double(r() % 3), 45)};
       }},
      {"through_origin",
       [](std::mt19937_64& r) {
         const Point3 p = families::random_point(r);
         return WeightedPoint3{p, square(p)};
       }},
      {"lifted_to_a_plane",
       [](std::mt19937_64& r) {
         const Point3 p = families::lattice_point(r, 300, 0.25);
         return WeightedPoint3{p, square(p)};
       }},
      {"far_away", [](std::mt19937_64& r) {
         const Point3 p = families::lattice_point(r, 3, 0x1p-20);
         return WeightedPoint3{{1e6 + p.x, -1e6 + p.y, 1e6 + p.z}, double(r() % 3) * 0x1p-40};
       }}};
  return all;
}

Sites draw(const Kind& kind, int count, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  Sites sites;
  for (int i = 0; i < count; ++i) sites.push_back(kind.draw(random));
  return sites;
}

double reach_of(const Sites& sites) {
  CoordinateRange range;
  for (const WeightedPoint3& site : sites) range.extend(site);
  return Predicates(range).in_sphere_reach();
}

class PowerRungs : public testing::TestWithParam<Kind> {};

TEST_P(PowerRungs, CertainEstimatesAgreeWithWideIntegersAndTheseWithUnlimitedOnes) {
  const Sites sites = draw(GetParam(), 5 * 4000, 31);
  const double reach = reach_of(sites);
  int certain = 0;
  int exact = 0;
  for (std::size_t i = 0; i + 5 <= sites.size(); i += 5) {
    const auto* s = &sites[i];
    const PowerEstimate estimate = estimate_power_test(s[0], s[1], s[2], s[3], s[4]);
    const int sign = detail::exact_power_test({s[0], s[1], s[2], s[3], s[4]});
    ASSERT_EQ(sign, reference::power_test({s[0], s[1], s[2], s[3], s[4]}));
    if (estimate.is_certain()) {
      ASSERT_EQ(estimate.sign(), sign);
    }
    if (estimate.is_exact(reach)) {
      ASSERT_EQ(estimate.sign(), sign);
    }
    certain += estimate.is_certain() ? 1 : 0;
    exact += estimate.is_exact(reach) ? 1 : 0;
  }
  const std::string& name = GetParam().name;
  if (name == "random") {
    EXPECT_GT(certain, 3900);
  }
  if (name == "lattice") {
    EXPECT_EQ(exact, 4000);
  }
  if (name == "wide_lattice") {
    EXPECT_GT(exact, 1000);
  }
  if (name == "heavy_lattice") {
    EXPECT_LT(exact, 1000) << "the limit of the lifts should tell";
  }
}

TEST_P(PowerRungs, InAPlaneCertainEstimatesAgreeWithWideIntegersAndTheseWithUnlimitedOnes) {
  Sites sites = draw(GetParam(), 4 * 4000, 32);
  for (WeightedPoint3& site : sites) site.point.z = 0;
  for (std::size_t i = 0; i + 4 <= sites.size(); i += 4) {
    const auto* s = &sites[i];
    const Predicates exact{CoordinateRange{}};
    const int orientation = exact.coplanar_orientation(s[0].point, s[1].point, s[2].point);
    if (orientation == 0) continue;
    const int sign = detail::exact_power_circle_xy({s[0], s[1], s[2], s[3]});
    ASSERT_EQ(orientation * sign, reference::power_circle({s[0], s[1], s[2], s[3]}));
    const Estimate estimate = estimate_power_circle_xy(s[0], s[1], s[2], s[3]);
    if (estimate.is_certain()) {
      ASSERT_EQ(estimate.sign(), sign);
    }
  }
}

/// Positively oriented cells over sites 1, 2, ...
std::vector<Cell> make_cells(const Sites& sites, int count) {
  CoordinateRange range;
  for (const WeightedPoint3& site : sites) range.extend(site);
  const Predicates exact(range);
  std::mt19937_64 random(33);
  std::uniform_int_distribution<std::uint32_t> vertex(1, std::uint32_t(sites.size() - 1));
  std::vector<Cell> cells;
  while (static_cast<int>(cells.size()) < count) {
    Cell cell{{vertex(random), vertex(random), vertex(random), vertex(random)}, {}};
    const auto& v = cell.vertex;
    const int sign =
        exact.orient3d(sites[v[0]].point, sites[v[1]].point, sites[v[2]].point, sites[v[3]].point);
    if (sign == 0) continue;
    if (sign < 0) std::swap(cell.vertex[0], cell.vertex[1]);
    cells.push_back(cell);
  }
  return cells;
}

TEST_P(PowerRungs, CertainLanesAgreeWithTheExactPredicate) {
  const Sites sites = draw(GetParam(), 400, 34);
  const std::vector<Cell> cells = make_cells(sites, 4000);
  const double reach = reach_of(sites);
  int certain = 0;
  for (std::size_t i = 0; i + 4 <= cells.size(); i += 4) {
    const std::array<const Cell*, 4> four{&cells[i], &cells[i + 1], &cells[i + 2], &cells[i + 3]};
    const WeightedPoint3& query = sites[i % 400];
    const auto found = detail::test_powers_portable(four, sites.data(), query, reach);
    for (unsigned lane = 0; lane < 4; ++lane) {
      const auto& v = four[lane]->vertex;
      const int sign =
          detail::exact_power_test({sites[v[0]], sites[v[1]], sites[v[2]], sites[v[3]], query});
      const bool inside = (found.inside >> lane & 1) != 0;
      const bool outside = (found.outside >> lane & 1) != 0;
      const bool tie = (found.cospherical >> lane & 1) != 0;
      ASSERT_LE(inside + outside + tie, 1);
      if (inside || outside || tie) {
        ASSERT_EQ(inside - outside, sign);
      }
      certain += inside + outside + tie;
    }
  }
  if (GetParam().name == "random" || GetParam().name == "lattice") {
    EXPECT_GT(certain, 3900) << "the filter should settle nearly all";
  }
}

#if defined(__x86_64__)
TEST_P(PowerRungs, VectorsAndPortableCodeAgreeBitForBit) {
  if (!__builtin_cpu_supports("avx2")) GTEST_SKIP() << "this processor has no AVX2";
  const Sites sites = draw(GetParam(), 400, 35);
  const std::vector<Cell> cells = make_cells(sites, 4000);
  for (const double reach : {0.0, reach_of(sites), 3.0, 1e9}) {
    for (std::size_t i = 0; i + 4 <= cells.size(); i += 4) {
      const std::array<const Cell*, 4> four{&cells[i], &cells[i + 1], &cells[i + 2], &cells[i + 3]};
      const WeightedPoint3& query = sites[i % 399];
      const auto a = detail::test_powers_portable(four, sites.data(), query, reach);
      const auto b = detail::test_powers_avx2(four, sites.data(), query, reach);
      ASSERT_EQ(a.inside, b.inside);
      ASSERT_EQ(a.outside, b.outside);
      ASSERT_EQ(a.cospherical, b.cospherical);
    }
  }
}
#endif

INSTANTIATE_TEST_SUITE_P(Kinds, PowerRungs, testing::ValuesIn(kinds()),
                         [](const auto& test) { return test.param.name; });

}  // namespace
}  // namespace stream_recon
