// The regular triangulation against brute force and against what must hold of it.
#include "spatial/regular_triangulation.h"

#include <gtest/gtest.h>

#include <numeric>
#include <random>

#include "spatial/delaunay.h"
#include "tests/delaunay_check.h"
#include "tests/point_families.h"
#include "tests/regular_check.h"

namespace stream_recon {
namespace {

using regular_check::brute_force;
using regular_check::expect_valid;
using regular_check::Sites;
using regular_check::tetrahedra;
using Outcome = RegularTriangulation::Outcome;

struct Weighting {
  std::string name;
  double (*weight)(const Point3&, std::mt19937_64&);
};

double square(const Point3& p) {
  return p.x * p.x + p.y * p.y + p.z * p.z;
}

// Weights of the order of the squared distances, so that some sites are hidden; steps and lifted
// ones make ties by the thousand.
const std::vector<Weighting>& weightings() {
  static const std::vector<Weighting> all = {
      {"equal", [](const Point3&, std::mt19937_64&) { return 1.0; }},
      {"random", [](const Point3& p, std::mt19937_64& r) { return square(p) * (r() % 100) / 256; }},
      {"heavy", [](const Point3& p, std::mt19937_64& r) { return square(p) * (r() % 64); }},
      {"below zero", [](const Point3& p, std::mt19937_64& r) { return -square(p) * (r() % 3); }},
      {"steps", [](const Point3& p, std::mt19937_64& r) { return p.y * p.y * (r() % 3); }},
      {"lifted to a plane", [](const Point3& p, std::mt19937_64&) { return square(p); }},
      {"lifted to a plane, a few not",
       [](const Point3& p, std::mt19937_64& r) { return square(p) * (r() % 4 == 0 ? 1.5 : 1); }}};
  return all;
}

Sites draw(const families::Family& family, const Weighting& weighting, int count,
           std::mt19937_64& random) {
  Sites sites;
  for (int i = 0; i < count; ++i) {
    const Point3 p = family.draw(random);
    sites.push_back({p, weighting.weight(p, random)});
  }
  return sites;
}

template <class Check>
void for_all_kinds(const Check& check) {
  for (std::size_t f = 0; f < families::all().size(); ++f) {
    for (std::size_t w = 0; w < weightings().size(); ++w) {
      const std::uint64_t seed = 100 * f + w;
      SCOPED_TRACE(families::all()[f].name + ", weights " + weightings()[w].name + ", seed " +
                   std::to_string(seed));
      std::mt19937_64 random(seed);
      check(families::all()[f], weightings()[w], random);
      if (testing::Test::HasFailure()) return;
    }
  }
}

void expect_brute_force(const Sites& sites) {
  RegularTriangulation regular;
  const Outcome outcome = regular.insert(sites);
  const auto expected = brute_force(sites);
  if (expected.empty()) {
    EXPECT_EQ(outcome, Outcome::kFlat);
    EXPECT_LT(regular.dimension(), 3);
    EXPECT_EQ(regular.hidden_count(), 0u);
    return;
  }
  ASSERT_EQ(outcome, Outcome::kDone);
  EXPECT_EQ(tetrahedra(regular), expected);
  expect_valid(regular, sites);
}

// Sites of the smaller families often fall on one place.
TEST(RegularTriangulation, equals_brute_force_on_few_sites_of_every_family) {
  for_all_kinds([](const auto& family, const auto& weighting, std::mt19937_64& random) {
    for (int count = 1; count <= 13; ++count) {
      ASSERT_NO_FATAL_FAILURE(expect_brute_force(draw(family, weighting, count, random)));
    }
  });
}

TEST(RegularTriangulation, is_valid_on_many_sites_of_every_family) {
  for_all_kinds([](const auto& family, const auto& weighting, std::mt19937_64& random) {
    const Sites sites = draw(family, weighting, 400, random);
    RegularTriangulation regular;
    const Outcome outcome = regular.insert(sites);
    if (family.name == "coplanar") {
      EXPECT_EQ(outcome, Outcome::kFlat);
      return;
    }
    ASSERT_EQ(outcome, Outcome::kDone);
    expect_valid(regular, sites);
  });
}

// The lowest index of an equal site.
std::vector<VertexId> first_of_equals(const Sites& sites) {
  std::vector<VertexId> names(sites.size());
  for (VertexId v = 0; v < sites.size(); ++v) {
    names[v] =
        static_cast<VertexId>(std::find(sites.begin(), sites.end(), sites[v]) - sites.begin());
  }
  return names;
}

TEST(RegularTriangulation, does_not_depend_on_the_order_of_insertion_or_on_batches) {
  for_all_kinds([](const auto& family, const auto& weighting, std::mt19937_64& random) {
    const Sites sites = draw(family, weighting, 150, random);
    const std::vector<VertexId> names = first_of_equals(sites);
    RegularTriangulation straight;
    const Outcome outcome = straight.insert(sites);
    std::vector<VertexId> order(sites.size());
    std::iota(order.begin(), order.end(), 0);
    std::shuffle(order.begin(), order.end(), random);
    RegularTriangulation other;
    Outcome last = Outcome::kFlat;
    for (const VertexId v : order) last = other.insert({&sites[v], 1});
    for (VertexId& v : order) v = names[v];
    EXPECT_EQ(last, outcome);
    EXPECT_EQ(other.hidden_count(), straight.hidden_count());
    EXPECT_EQ(tetrahedra(other, order), tetrahedra(straight));
  });
}

TEST(RegularTriangulation, equal_weights_make_the_delaunay_triangulation) {
  for (const families::Family& family : families::all()) {
    SCOPED_TRACE(family.name);
    std::mt19937_64 random(7);
    std::set<Point3> points;
    for (int i = 0; i < 500; ++i) points.insert(family.draw(random));
    const std::vector<Point3> cloud(points.begin(), points.end());
    Sites sites;
    for (const Point3& p : cloud) sites.push_back({p, 3});
    Delaunay delaunay;
    RegularTriangulation regular;
    ASSERT_EQ(regular.insert(sites), delaunay.insert(cloud));
    EXPECT_EQ(tetrahedra(regular), delaunay_check::tetrahedra(delaunay));
    EXPECT_EQ(regular.hidden_count(), 0u);
  }
}

TEST(RegularTriangulation, heaviest_site_of_a_place_is_the_vertex_of_equal_ones_the_first) {
  const Sites corners{{{0, 0, 0}, 0}, {{4, 0, 0}, 0}, {{0, 4, 0}, 0}, {{0, 0, 4}, 0}};
  const Point3 inside{1, 1, 1};
  const std::vector<double> weights{1, 3, 2, 3, 0};
  std::vector<VertexId> order(weights.size());
  std::iota(order.begin(), order.end(), 0);
  do {
    for (const bool at_corner : {false, true}) {
      Sites sites = corners;
      for (const VertexId i : order)
        sites.push_back({at_corner ? corners[2].point : inside, weights[i]});
      RegularTriangulation regular;
      ASSERT_EQ(regular.insert(sites), Outcome::kDone);
      expect_valid(regular, sites);
      VertexId vertex = 4;
      while (sites[vertex].weight < 3) ++vertex;
      EXPECT_FALSE(regular.is_hidden(vertex));
      EXPECT_EQ(regular.hidden_count(), at_corner ? 5u : 4u);
    }
  } while (std::next_permutation(order.begin(), order.end()));
}

TEST(RegularTriangulation, one_heavy_site_hides_a_thousand) {
  std::mt19937_64 random(3);
  Sites sites;
  for (int i = 0; i < 1000; ++i) sites.push_back({families::random_point(random), 0});
  for (const double s : {-9.0, 9.0}) {
    sites.push_back({{s, 0, 0}, 0});
    sites.push_back({{0, s, 0}, 0});
    sites.push_back({{0, 0, s}, 0});
  }
  RegularTriangulation regular;
  ASSERT_EQ(regular.insert(sites), Outcome::kDone);
  EXPECT_EQ(regular.hidden_count(), 0u);
  sites.push_back({{0.1, 0.2, 0.3}, 60});
  ASSERT_EQ(regular.insert({&sites.back(), 1}), Outcome::kDone);
  EXPECT_EQ(regular.hidden_count(), 1000u);
  expect_valid(regular, sites);
}

TEST(RegularTriangulation, knows_the_dimension_of_flat_clouds) {
  RegularTriangulation regular;
  EXPECT_EQ(regular.insert({}), Outcome::kFlat);
  EXPECT_EQ(regular.dimension(), -1);
  const Sites place{{{5, 5, 5}, 1}, {{5, 5, 5}, 2}, {{5, 5, 5}, 1}};
  EXPECT_EQ(regular.insert(place), Outcome::kFlat);
  EXPECT_EQ(regular.dimension(), 0);
  const Sites line{{{6, 7, 8}, 9}, {{3, 1, -1}, 0}, {{4, 3, 2}, -4}};
  EXPECT_EQ(regular.insert(line), Outcome::kFlat);
  EXPECT_EQ(regular.dimension(), 1);
  const Sites plane{{{5, 0, 0}, 9}, {{5, -5, -5}, 100}};
  EXPECT_EQ(regular.insert(plane), Outcome::kFlat);
  EXPECT_EQ(regular.dimension(), 2);
  EXPECT_EQ(regular.hidden_count(), 0u);
  const Sites apex{{{0, 0, 100}, 0}};
  EXPECT_EQ(regular.insert(apex), Outcome::kDone);
  Sites all;
  for (const Sites& part : {place, line, plane, apex})
    all.insert(all.end(), part.begin(), part.end());
  expect_valid(regular, all);
}

// In the manner of spatial_conflict_test.cpp.
TEST(RegularTriangulation, cells_in_conflict_are_those_that_insertion_destroys) {
  for_all_kinds([](const auto& family, const auto& weighting, std::mt19937_64& random) {
    const Sites sites = draw(family, weighting, 60, random);
    RegularTriangulation::Options options;
    for (const WeightedPoint3& site : sites) options.range.extend(site);
    RegularTriangulation before(options);
    RegularTriangulation after(options);
    if (before.insert({sites.data(), sites.size() - 1}) != Outcome::kDone) return;
    ASSERT_EQ(after.insert(sites), Outcome::kDone);
    const bool is_twin = std::find(sites.begin(), sites.end() - 1, sites.back()) != sites.end() - 1;
    if (is_twin) return;
    const auto left = tetrahedra(after);
    for (CellId c = 0; c < before.cell_slots(); ++c) {
      if (!before.is_live(c) || before.is_infinite(c)) continue;
      auto corners = before.vertices(c);
      std::sort(corners.begin(), corners.end());
      ASSERT_EQ(before.in_conflict(c, sites.back()), !left.contains(corners)) << "cell " << c;
    }
  });
}

TEST(RegularTriangulation, does_not_change_with_the_scale) {
  std::mt19937_64 random(9);
  const Sites sites = draw(families::all()[1], weightings()[2], 300, random);
  RegularTriangulation plain;
  ASSERT_EQ(plain.insert(sites), Outcome::kDone);
  for (const double scale : {0x1p-400, 0x1p400}) {
    Sites scaled;
    for (const auto& [p, weight] : sites)
      scaled.push_back({{p.x * scale, p.y * scale, p.z * scale}, weight * scale * scale});
    RegularTriangulation other;
    ASSERT_EQ(other.insert(scaled), Outcome::kDone);
    EXPECT_EQ(tetrahedra(other), tetrahedra(plain));
    for (VertexId v = 0; v < sites.size(); ++v) ASSERT_EQ(other.site(v), scaled[v]);
  }
}

TEST(RegularTriangulation, stops_at_its_memory_limit) {
  std::mt19937_64 random(6);
  const Sites sites = draw(families::all()[0], weightings()[0], 20000, random);
  RegularTriangulation unlimited;
  ASSERT_EQ(unlimited.insert(sites), Outcome::kDone);
  RegularTriangulation::Options options;
  options.max_bytes = unlimited.bytes() / 2;
  RegularTriangulation limited(options);
  EXPECT_EQ(limited.insert(sites), Outcome::kOutgrown);
  EXPECT_LE(limited.bytes(), options.max_bytes);
}

TEST(RegularTriangulation, refuses_weights_too_far_apart_in_magnitude) {
  const Sites sites{{{1, 0, 0}, 0x1p-900}, {{0, 1, 0}, 0x1p900}};
  RegularTriangulation regular;
  EXPECT_EQ(regular.insert(sites), Outcome::kBadRange);
}

}  // namespace
}  // namespace stream_recon
