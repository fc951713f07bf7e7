// What the measurement of known solids finds on meshes whose error is known.

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "spatial/vector.h"
#include "tests/benchmarks/label_error.h"
#include "tests/benchmarks/sample_distance.h"
#include "tests/benchmarks/sample_match.h"
#include "tools/clouds/trigonometry.h"

namespace stream_recon {
namespace {

using Triangle = std::array<Point3, 3>;

constexpr double kCell = 0.02;

/// Rings of latitude and meridians, each quadrangle as two triangles.
std::vector<Triangle> sphere_mesh(double radius, const Point3& center, int rings = 60) {
  const auto point = [&](int ring, int turn) {
    const double polar = kPi * ring / rings;
    const double around = kPi * turn / rings;
    const Point3 u{std::sin(polar) * std::cos(around), std::sin(polar) * std::sin(around),
                   std::cos(polar)};
    return plus(center, scaled(u, radius));
  };
  std::vector<Triangle> mesh;
  for (int ring = 0; ring < rings; ++ring) {
    for (int turn = 0; turn < 2 * rings; ++turn) {
      const int next = (turn + 1) % (2 * rings);
      mesh.push_back({point(ring, turn), point(ring + 1, turn), point(ring + 1, next)});
      mesh.push_back({point(ring, turn), point(ring + 1, next), point(ring, next)});
    }
  }
  return mesh;
}

/// The faces of all voxels of a grid that lie in the solid.
std::vector<Triangle> voxel_mesh(const KnownSolid& solid, double pixel) {
  std::vector<Triangle> mesh;
  const auto half = static_cast<int>(solid.reach() / pixel) + 2;
  const auto inside = [&](const std::array<int, 3>& voxel) {
    return solid.contains({voxel[0] * pixel, voxel[1] * pixel, voxel[2] * pixel});
  };
  const auto add_face = [&](const std::array<int, 3>& voxel, std::size_t axis) {
    const auto corner = [&](int a, int b) {
      std::array<double, 3> place{};
      place[axis] = voxel[axis] + 0.5;
      place[(axis + 1) % 3] = voxel[(axis + 1) % 3] + a - 0.5;
      place[(axis + 2) % 3] = voxel[(axis + 2) % 3] + b - 0.5;
      return Point3{place[0] * pixel, place[1] * pixel, place[2] * pixel};
    };
    mesh.push_back({corner(0, 0), corner(1, 0), corner(1, 1)});
    mesh.push_back({corner(0, 0), corner(1, 1), corner(0, 1)});
  };
  for (int z = -half; z < half; ++z) {
    for (int y = -half; y < half; ++y) {
      for (int x = -half; x < half; ++x) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
          std::array<int, 3> next{x, y, z};
          ++next[axis];
          if (inside({x, y, z}) != inside(next)) add_face({x, y, z}, axis);
        }
      }
    }
  }
  return mesh;
}

LabelError error_of(const std::vector<Triangle>& mesh, const KnownSolid& solid,
                    double cell = kCell) {
  LabelErrorMeter meter(solid, cell);
  for (const Triangle& triangle : mesh) meter.add_triangle(triangle);
  return meter.measure();
}

double ball_volume(double radius) {
  return 4 * kPi / 3 * radius * radius * radius;
}

TEST(SolidQuality, AFineMeshIsWrongByItsDiscretizationOnly) {
  const auto solid = make_solid({"sphere"});
  const LabelError coarse = error_of(sphere_mesh(1, {}, 20), *solid);
  const LabelError fine = error_of(sphere_mesh(1, {}, 80), *solid);
  EXPECT_NEAR(coarse.wrong_volume, coarse.solid_volume - coarse.mesh_volume, 1e-6);
  EXPECT_LT(fine.wrong_volume, 0.003);
  EXPECT_NEAR(coarse.wrong_volume / fine.wrong_volume, 16, 1);
  EXPECT_EQ(fine.odd_rays, 0U);
}

TEST(SolidQuality, BallsThatAreTooSmallOrTooLargeAreWrongByTheDifference) {
  const auto solid = make_solid({"sphere"});
  for (const double radius : {0.5, 0.9, 1.1, 3.0}) {
    const double wrong = std::abs(ball_volume(radius) - ball_volume(1));
    EXPECT_NEAR(error_of(sphere_mesh(radius, {}), *solid).wrong_volume, wrong, 0.01 * wrong)
        << radius;
  }
}

TEST(SolidQuality, ABallElsewhereIsWrongTwice) {
  const auto solid = make_solid({"sphere"});
  const Point3 far{0.3, -5, 70};
  EXPECT_NEAR(error_of(sphere_mesh(1, far), *solid).wrong_volume, 2 * ball_volume(1), 0.03);
  // Two balls of radius 1 whose centres are d apart have 2 pi (1 - 3 d / 4 + d^3 / 16) / 1.5 in
  // common.
  const double d = 0.6;
  const double common = 4 * kPi / 3 * (1 - 3 * d / 4 + d * d * d / 16);
  EXPECT_NEAR(error_of(sphere_mesh(1, {0, d, 0}), *solid).wrong_volume,
              2 * (ball_volume(1) - common), 0.03);
}

TEST(SolidQuality, NoMeshIsWrongByTheWholeSolid) {
  for (const std::string_view name : solid_names()) {
    const auto solid = make_solid({std::string(name)});
    const double volume = solid->truth().volume;
    EXPECT_NEAR(error_of({}, *solid).wrong_volume, volume, 0.01 * volume) << name;
  }
}

TEST(SolidQuality, AFilledCavityIsCounted) {
  const auto solid = make_solid({"nested"});
  EXPECT_NEAR(error_of(sphere_mesh(1, {}), *solid).wrong_volume,
              ball_volume(0.7) - ball_volume(0.4), 0.02);
}

TEST(SolidQuality, MeshesOfVoxelsHaveNoOddRays) {
  const auto solid = make_solid({"folded"});
  for (const double pixel : {kCell, 2 * kCell, 0.0625}) {
    const LabelError error = error_of(voxel_mesh(*solid, pixel), *solid);
    EXPECT_EQ(error.odd_rays, 0U) << pixel;
    EXPECT_GT(error.wrong_volume, 0);
    EXPECT_LT(error.wrong_volume, pixel / 2 * solid->truth().area) << pixel;
  }
}

TEST(SolidQuality, AHoleMakesOddRays) {
  const auto solid = make_solid({"sphere"});
  std::vector<Triangle> mesh = sphere_mesh(1, {}, 20);
  mesh.erase(mesh.begin() + 400);
  const LabelError error = error_of(mesh, *solid);
  EXPECT_GT(error.odd_rays, 0U);
  EXPECT_LT(error.odd_rays, error.rays / 10);
}

TEST(SolidQuality, SamplesAreMatchedByTheirCoordinates) {
  const SampleMatch match = match_samples({{1, 2, 3}, {4, 5, 6}, {1, 2, 3}, {7, 8, 9}, {0, 0, 0}},
                                          {{7, 8, 9}, {1, 2, 3}, {1, 2, 3.5}, {7, 8, 9}});
  EXPECT_EQ(match.samples, 4U);
  EXPECT_EQ(match.matched, 2U);
  EXPECT_EQ(match.added_vertices, 1U);
}

TEST(SampleDistance, IsHowFarSamplesWereMovedEitherWay) {
  for (const std::string name : {"sphere", "torus", "blob", "folds"}) {
    const auto solid = make_solid({name});
    Random random(4);
    for (const double moved : {0.01, -0.01}) {
      std::vector<Point3> samples;
      while (samples.size() < 500) {
        const auto p = solid->try_surface_point(random);
        if (p) samples.push_back(plus(*p, scaled(solid->outward_normal(*p), moved)));
      }
      EXPECT_NEAR(mean_distance(*solid, samples, 0.1), 0.01, 1e-4) << name << moved;
      EXPECT_NEAR(mean_distance(*solid, samples, 0.001), 0.001, 1e-12) << "the reach bounds it";
    }
  }
}

}  // namespace
}  // namespace stream_recon
