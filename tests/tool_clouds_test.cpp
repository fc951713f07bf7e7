#include "tools/clouds/cloud.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <map>
#include <string>
#include <tuple>
#include <vector>

#include "tools/clouds/trigonometry.h"

namespace stream_recon {
namespace {

std::vector<Point3> points_of(const CloudOptions& options, std::size_t portion = 4096) {
  const auto source = make_cloud(options);
  std::vector<Point3> all;
  std::vector<Point3> buffer(portion);
  while (const std::size_t n = source->read(buffer)) {
    all.insert(all.end(), buffer.begin(), buffer.begin() + static_cast<std::ptrdiff_t>(n));
  }
  EXPECT_EQ(source->announced_count(), all.size());
  return all;
}

// FNV-1a over the bits of all coordinates.
std::uint64_t digest(const std::vector<Point3>& points) {
  std::uint64_t hash = 0xcbf29ce484222325U;
  for (const Point3& p : points)
    for (const double value : {p.x, p.y, p.z})
      hash = (hash ^ std::bit_cast<std::uint64_t>(value)) * 0x100000001b3U;
  return hash;
}

double length(const Point3& p) {
  return std::sqrt(p.x * p.x + p.y * p.y + p.z * p.z);
}

double gyroid(const Point3& p) {
  const double k = 3 * kPi;
  return std::sin(k * p.x) * std::cos(k * p.y) + std::sin(k * p.y) * std::cos(k * p.z) +
         std::sin(k * p.z) * std::cos(k * p.x);
}

template <typename Predicate>
double share(const std::vector<Point3>& points, Predicate holds) {
  return static_cast<double>(std::count_if(points.begin(), points.end(), holds)) /
         static_cast<double>(points.size());
}

TEST(Clouds, EveryKindKeepsItsBits) {
  const std::map<std::string_view, std::uint64_t> pinned{
      {"cube", 0xa462d8b15562a8bdU},      {"sphere", 0xb6a8d4daba4851e5U},
      {"ellipsoid", 0x0b3f8a7399e58bdeU}, {"blob", 0xe28206a9a365cb60U},
      {"torus", 0x189ff34fd31d1429U},     {"folded", 0xf5631873957a0b0dU},
      {"lattice", 0xdfb954a5da464b85U},   {"shell", 0x296b29dd2ba3ace7U},
      {"line", 0xc3e72c2e180ff2dfU},      {"plane", 0x39668a2832dee6b6U},
      {"circle", 0x3d245b094c57b5c7U},    {"helix", 0xd8a5635181dd1bdeU},
      {"skew", 0x8384380e73e12405U},      {"sponge", 0xe0811a22bdab49ddU},
      {"folds", 0x848cba314f273bd5U},     {"nested", 0x595c93347c966685U},
      {"pair", 0x959966ae796058b2U},      {"plate", 0x11dfdfe5591c3e40U},
      {"uneven", 0x921e502b61b5190dU},
  };
  for (const CloudKind& kind : cloud_kinds()) {
    SCOPED_TRACE(kind.name);
    ASSERT_TRUE(pinned.contains(kind.name));
    EXPECT_EQ(digest(points_of({std::string(kind.name), 1000, 7, 2})), pinned.at(kind.name));
  }
}

TEST(Clouds, EverySamplingOfASolidKeepsItsBits) {
  const std::map<SolidSampling, std::uint64_t> pinned{
      {SolidSampling::kNoisy, 0x1c4368e8bf456028U},
      {SolidSampling::kCrossings, 0x04ea5350f0517807U},
      {SolidSampling::kFaces, 0xb7826cd13144ae9dU},
      {SolidSampling::kCentres, 0xa33c8c93d076c5bdU},
  };
  for (const auto& [sampling, bits] : pinned)
    EXPECT_EQ(digest(points_of({"blob", 1000, 7, 2, sampling})), bits);
}

TEST(Clouds, EveryKindDeliversTheCountAskedFor) {
  for (const CloudKind& kind : cloud_kinds()) {
    for (const std::uint64_t count : {0U, 1U, 2U, 4095U, 4097U, 20000U}) {
      SCOPED_TRACE(std::string(kind.name) + " " + std::to_string(count));
      const auto delivered = static_cast<double>(points_of({std::string(kind.name), count}).size());
      const bool close_will_do = kind.name == "shell";
      if (close_will_do && count < 1000) continue;
      EXPECT_NEAR(delivered, count, close_will_do ? 0.1 * count : 0);
    }
  }
}

TEST(Clouds, PortionsDoNotChangeThePoints) {
  for (const CloudKind& kind : cloud_kinds()) {
    SCOPED_TRACE(kind.name);
    const CloudOptions options{std::string(kind.name), 500, 3};
    EXPECT_EQ(points_of(options, 1), points_of(options, 4096));
  }
}

TEST(Clouds, SeedsMakeDifferentClouds) {
  for (const char* kind : {"cube", "sphere", "ellipsoid", "blob", "torus", "folded", "sponge",
                           "folds", "nested", "pair", "plate", "uneven", "line", "plane"})
    EXPECT_NE(points_of({kind, 10, 1}), points_of({kind, 10, 2})) << kind;
}

TEST(Clouds, ATrillionPointsBeginAtOnce) {
  const auto source = make_cloud({"folded", 1'000'000'000'000});
  std::vector<Point3> buffer(10);
  EXPECT_EQ(source->read(buffer), 10U);
  EXPECT_EQ(source->announced_count(), 1'000'000'000'000U);
}

TEST(Clouds, UnknownKindIsRefused) {
  EXPECT_THROW(make_cloud({"cubes", 10}), std::invalid_argument);
  EXPECT_THROW(make_cloud({"shell", 10, 1, 0}), std::invalid_argument);
  EXPECT_THROW(make_cloud({"cube", 10, 1, 3, SolidSampling::kFaces}), std::invalid_argument);
}

TEST(Clouds, LineAndPlaneAreExact) {
  for (const Point3& p : points_of({"line", 10000}))
    EXPECT_TRUE(p.y == 2 * p.x && p.z - p.y == p.x);
  for (const Point3& p : points_of({"plane", 10000})) EXPECT_EQ(p.z - p.y, p.x);
}

TEST(Clouds, FoldedPointsLieOnTheSolidsSurface) {
  for (const Point3& p : points_of({"folded", 20000})) {
    const bool on_ball = std::abs(length(p) - 1) < 1e-15 && gyroid(p) < 1e-12;
    const bool on_gyroid = std::abs(gyroid(p)) < 1e-12 && length(p) <= 1;
    EXPECT_TRUE(on_ball || on_gyroid) << p.x << ' ' << p.y << ' ' << p.z;
  }
}

// A gyroid has 3.0919 of area a cubic period of side 1, so here 19.43; the ball's half has 6.28.
TEST(Clouds, FoldedPointsAreAsDenseOnTheBallAsOnTheGyroid) {
  const auto points = points_of({"folded", 40000, 5});
  EXPECT_NEAR(share(points, [](const Point3& p) { return std::abs(gyroid(p)) > 1e-9; }),
              6.28 / (6.28 + 19.43), 0.02);
}

TEST(Clouds, TorusAndEllipsoidAreFair) {
  const auto torus = points_of({"torus", 100000, 5});
  EXPECT_NEAR(share(torus, [](const Point3& p) { return std::hypot(p.x, p.y) > 1; }),
              0.5 + 0.4 / kPi, 0.005);
  // The zone |z| < 0.25 of the ellipsoid, by numerical integration of its area element.
  double zone = 0;
  double whole = 0;
  for (int i = 0; i < 1000; ++i) {
    for (int j = 0; j < 1000; ++j) {
      const double z = (i + 0.5) / 1000;
      const double turn = 2 * kPi * (j + 0.5) / 1000;
      const double ring = std::sqrt(1 - z * z);
      const double area = std::hypot(ring * std::cos(turn), ring * std::sin(turn) / 0.7, z / 0.5);
      whole += area;
      if (z < 0.5) zone += area;
    }
  }
  const auto ellipsoid = points_of({"ellipsoid", 100000, 5});
  EXPECT_NEAR(share(ellipsoid, [](const Point3& p) { return std::abs(p.z) < 0.25; }), zone / whole,
              0.005);
}

TEST(Clouds, ShellIsTheBoundaryOfTheSlicedSolid) {
  const auto points = points_of({"shell", 20000, 1, 3});
  double radius = 0;
  for (const Point3& p : points) {
    EXPECT_TRUE(p.x == std::floor(p.x) && p.y == std::floor(p.y) && std::remainder(p.z, 3) == 0);
    radius = std::max(radius, length(p));
  }
  radius = std::floor(radius + 0.5);
  const auto inside = [&](double x, double y, double z) {
    const Point3 p{x / radius, y / radius, z / radius};
    return length(p) <= 1 && gyroid(p) < -1e-9;
  };
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Point3& p = points[i];
    if (i > 0) {
      EXPECT_LT(std::tie(points[i - 1].z, points[i - 1].y, points[i - 1].x),
                std::tie(p.z, p.y, p.x));
    }
    EXPECT_FALSE(inside(p.x - 1, p.y, p.z) && inside(p.x + 1, p.y, p.z) &&
                 inside(p.x, p.y - 1, p.z) && inside(p.x, p.y + 1, p.z) &&
                 inside(p.x, p.y, p.z - 3) && inside(p.x, p.y, p.z + 3));
  }
}

TEST(Clouds, OwnSineAgreesWithTheLibrary) {
  for (double angle = -1000; angle < 1000; angle += 0.37) {
    EXPECT_NEAR(sine_cosine(angle).sine, std::sin(angle), 1e-15) << angle;
    EXPECT_NEAR(sine_cosine(angle).cosine, std::cos(angle), 1e-15) << angle;
  }
}

}  // namespace
}  // namespace stream_recon
