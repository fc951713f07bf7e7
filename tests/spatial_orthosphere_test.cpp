// The sphere orthogonal to four balls, and what it is in conflict with, against exact arithmetic.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include "spatial/orthosphere.h"
#include "spatial/vector.h"
#include "tests/exact_reference.h"
#include "tests/point_families.h"

namespace stream_recon {
namespace {

using Rational = boost::multiprecision::cpp_rational;
using Vector = std::array<Rational, 3>;
using Sites = std::array<WeightedPoint3, 4>;
using Corners = std::array<Point3, 4>;

/// Of balls whose centres lie within the unit ball.
constexpr OrthosphereReach kReach{.reach = 2, .most_error = 1e-9, .rounding = 0x1p-50};
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr int kCases = 30;
#else
constexpr int kCases = 300;
#endif

Rational dot(const Vector& a, const Vector& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

Vector exact(const Point3& p) {
  return {Rational(p.x), Rational(p.y), Rational(p.z)};
}

Vector minus(const Vector& a, const Vector& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

Rational determinant(const std::array<Vector, 3>& m) {
  const auto& [a, b, c] = m;
  return a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) +
         a[2] * (b[0] * c[1] - b[1] * c[0]);
}

struct ExactSphere {
  Vector centre;
  Rational weight;

  /// Of the centre to a ball of weight 0 around c, minus the sphere's weight.
  Rational power_beyond(const Point3& c) const {
    const Vector d = minus(exact(c), centre);
    return dot(d, d) - weight;
  }
};

/// Nothing if the sites are coplanar.
std::optional<ExactSphere> exact_sphere(const Sites& sites) {
  const Vector first = exact(sites[0].point);
  std::array<Vector, 3> rows;
  Vector right;
  for (std::size_t j = 0; j < 3; ++j) {
    rows[j] = minus(exact(sites[j + 1].point), first);
    right[j] =
        (dot(rows[j], rows[j]) - Rational(sites[j + 1].weight) + Rational(sites[0].weight)) / 2;
  }
  const Rational all = determinant(rows);
  if (all == 0) return std::nullopt;
  Vector z;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    auto replaced = rows;
    for (std::size_t row = 0; row < 3; ++row) replaced[row][axis] = right[row];
    z[axis] = determinant(replaced) / all;
  }
  const Rational weight = dot(z, z) - Rational(sites[0].weight);
  return ExactSphere{{z[0] + first[0], z[1] + first[1], z[2] + first[2]}, weight};
}

/// Within the unit ball, and so are the radii.
Point3 in_ball(std::mt19937_64& random) {
  for (;;) {
    const Point3 p = families::random_point(random);
    if (length(p) <= 1) return p;
  }
}

/// Four balls, the fourth centre off the plane of the others by about 10^-flatness.
Sites random_sites(double flatness, std::mt19937_64& random) {
  std::uniform_real_distribution<double> radius(0, 1);
  Sites sites;
  for (WeightedPoint3& site : sites) {
    const double r = radius(random);
    site = {in_ball(random), r * r};
  }
  if (flatness > 0) {
    const Point3 mean = scaled(plus(plus(sites[0].point, sites[1].point), sites[2].point), 1. / 3);
    sites[3].point = plus(mean, scaled(sites[3].point, std::pow(10.0, -flatness)));
  }
  return sites;
}

/// By no more than a site of this size may be off.
double wander(double size, std::mt19937_64& random) {
  const double most = size * kReach.rounding / 2;
  return std::uniform_real_distribution<double>(-most, most)(random);
}

/// Within what the stored balls may be off.
Sites rounded(const Sites& sites, std::mt19937_64& random) {
  Sites near = sites;
  for (WeightedPoint3& site : near) {
    const double size = length(site.point) + std::sqrt(site.weight);
    site.point =
        plus(site.point, {wander(size, random), wander(size, random), wander(size, random)});
    const double radius = std::max(0.0, std::sqrt(site.weight) + wander(size, random));
    site.weight = radius * radius;
  }
  return near;
}

TEST(Orthosphere, IsAsFarFromItsFourBallsWithinItsError) {
  std::mt19937_64 random(1);
  int told = 0;
  for (int i = 0; i < 10 * kCases; ++i) {
    const Sites sites = random_sites(0.001 * (i % 7000), random);
    const auto sphere = orthosphere(sites, kReach);
    if (!sphere) continue;
    ++told;
    EXPECT_GT(sphere->error, 0);
    EXPECT_LT(sphere->error, kReach.most_error);
    for (const WeightedPoint3& site : sites) {
      const Vector d = minus(exact(site.point), exact(sphere->centre));
      const Rational missed = dot(d, d) - Rational(site.weight) - Rational(sphere->weight);
      EXPECT_LE(abs(missed), Rational(sphere->error));
    }
  }
  EXPECT_GT(told, 4 * kCases);
}

TEST(Orthosphere, HasTheErrorThatItSaysToEveryBallWithinReachOfRoundedSitesToo) {
  std::mt19937_64 random(2);
  for (int i = 0; i < kCases; ++i) {
    const Sites truth = random_sites(0.01 * (i % 700), random);
    const auto sphere = orthosphere(rounded(truth, random), kReach);
    const auto expected = exact_sphere(truth);
    if (!sphere || !expected) continue;
    const ExactSphere found{exact(sphere->centre), Rational(sphere->weight)};
    for (int k = 0; k < 8; ++k) {
      const Point3 p = in_ball(random);
      const Point3 c = k < 4 ? scaled(p, 1 / length(p)) : p;
      const Rational missed = found.power_beyond(c) - expected->power_beyond(c);
      EXPECT_LE(abs(missed), Rational(sphere->error)) << "case " << i;
    }
  }
}

TEST(Orthosphere, OfBallsThatAreNearlyCoplanarTellsNothing) {
  std::mt19937_64 random(3);
  for (int i = 0; i < kCases; ++i) {
    EXPECT_FALSE(orthosphere(random_sites(13, random), kReach));
    Sites flat = random_sites(0, random);
    for (WeightedPoint3& site : flat) site.point.z = 0.5;
    EXPECT_FALSE(orthosphere(flat, kReach));
    flat[1] = flat[0];
    EXPECT_FALSE(orthosphere(flat, kReach));
    const Point3 centre = orthocentre(flat);
    EXPECT_TRUE(is_finite(centre));
    EXPECT_LE(length(centre), 1);
  }
}

TEST(Orthocentre, IsTheCentreOfTheSphere) {
  std::mt19937_64 random(4);
  for (int i = 0; i < kCases; ++i) {
    const Sites sites = random_sites(0, random);
    const auto sphere = orthosphere(sites, kReach);
    if (sphere) {
      EXPECT_EQ(orthocentre(sites), sphere->centre);
    }
  }
}

/// Whether the tetrahedron is in conflict with (centre, limit).
bool is_in_conflict(const Corners& t, const Point3& centre, double limit) {
  const int turn = reference::orient3d(t[0], t[1], t[2], t[3]);
  const int side =
      reference::power_test({{{t[0], 0}, {t[1], 0}, {t[2], 0}, {t[3], 0}, {centre, limit}}});
  return turn * side > 0;
}

/// The power of the centre to the circumsphere: nothing for coplanar corners.
std::optional<Rational> exact_power(const Corners& t, const Point3& centre) {
  const auto ball = exact_sphere({{{t[0], 0}, {t[1], 0}, {t[2], 0}, {t[3], 0}}});
  if (!ball) return std::nullopt;
  return ball->power_beyond(centre);
}

/// Weights around the tie of a tetrahedron and a centre: some in conflict by little, some not.
std::vector<double> weights_near(double power, double scale, std::mt19937_64& random) {
  std::vector<double> weights{
      power,        std::nextafter(power, -1e300), std::nextafter(power, 1e300), 0, -scale * scale,
      scale * scale};
  for (int i = 0; i < 12; ++i) {
    const double step = std::pow(10.0, -1.5 * i);
    weights.push_back(power + (random() % 2 != 0 ? step : -step) * std::fabs(power));
  }
  return weights;
}

class MayConflict : public testing::TestWithParam<families::Family> {};

TEST_P(MayConflict, IsTrueOfEveryTetrahedronThatIsInConflict) {
  std::mt19937_64 random(5);
  int conflicts = 0;
  for (int i = 0; i < kCases; ++i) {
    Corners t{GetParam().draw(random), GetParam().draw(random), GetParam().draw(random),
              GetParam().draw(random)};
    const Point3 centre = GetParam().draw(random);
    const auto power = exact_power(t, centre);
    if (!power) continue;
    const double scale = length(minus(t[0], centre));
    for (const double weight : weights_near(power->convert_to<double>(), scale, random)) {
      std::swap(t[random() % 2], t[2 + random() % 2]);
      for (const double error : {0.0, 1e-12 * scale * scale}) {
        if (!is_in_conflict(t, centre, weight + error)) continue;
        ++conflicts;
        ASSERT_TRUE(may_conflict(t, {centre, weight, error})) << "case " << i;
      }
    }
  }
  // Families in one plane have no tetrahedra.
  if (GetParam().name != "coplanar") {
    EXPECT_GT(conflicts, kCases);
  }
}

INSTANTIATE_TEST_SUITE_P(Families, MayConflict, testing::ValuesIn(families::all()),
                         [](const auto& test) {
                           std::string name = test.param.name;
                           std::replace(name.begin(), name.end(), ' ', '_');
                           return name;
                         });

TEST(MayConflictOfSlivers, IsTrueWhereTheyAreInConflict) {
  std::mt19937_64 random(6);
  int conflicts = 0;
  for (int i = 0; i < kCases; ++i) {
    const Sites flat = random_sites(0.05 * (i % 400), random);
    Corners t{flat[0].point, flat[1].point, flat[2].point, flat[3].point};
    const Point3 centre = i % 2 == 0 ? in_ball(random) : families::nudged(t[i % 4], random);
    const auto power = exact_power(t, centre);
    if (!power) continue;
    for (const double weight : weights_near(power->convert_to<double>(), 1, random)) {
      std::swap(t[random() % 2], t[2 + random() % 2]);
      if (!is_in_conflict(t, centre, weight)) continue;
      ++conflicts;
      ASSERT_TRUE(may_conflict(t, {centre, weight, 0})) << "case " << i;
    }
  }
  EXPECT_GT(conflicts, kCases);
}

TEST(MayConflictOfOthers, IsTrueNearATieAlone) {
  std::mt19937_64 random(7);
  int refused = 0;
  for (int i = 0; i < 10 * kCases; ++i) {
    Corners t{in_ball(random), in_ball(random), in_ball(random), in_ball(random)};
    const Point3 d = cross(minus(t[1], t[0]), minus(t[2], t[0]));
    if (std::fabs(dot(d, minus(t[3], t[0]))) < 1e-3) continue;
    const Point3 centre = in_ball(random);
    const double power = exact_power(t, centre)->convert_to<double>();
    const double margin = std::pow(10.0, -2 - static_cast<double>(random() % 8));
    std::swap(t[random() % 2], t[2 + random() % 2]);
    // In conflict are those whose power is below the weight.
    EXPECT_FALSE(may_conflict(t, {centre, power - margin, margin / 2}));
    EXPECT_TRUE(may_conflict(t, {centre, power - margin, 2 * margin}));
    EXPECT_TRUE(may_conflict(t, {centre, power + margin, 0}));
    ++refused;
  }
  EXPECT_GT(refused, 5 * kCases);
}

TEST(MayConflictOfOthers, IsFalseOnALatticeFarFromTheSphere) {
  // What walks ask about: the cells of a voxel shell, against small spheres that are far from them.
  std::mt19937_64 random(8);
  for (int i = 0; i < 10 * kCases; ++i) {
    const Corners t{families::lattice_point(random, 3, 1), families::lattice_point(random, 3, 1),
                    families::lattice_point(random, 3, 1), families::lattice_point(random, 3, 1)};
    const Point3 centre{0.5 + static_cast<double>(random() % 3), 10, 0.25};
    const auto power = exact_power(t, centre);
    if (!power || *power < 1) continue;
    EXPECT_FALSE(may_conflict(t, {centre, 0.5, 0.25}));
  }
}

}  // namespace
}  // namespace stream_recon
