// The solid surface, as a user gets it: closed, through its samples, the same bytes for any memory
// and threads.

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <random>
#include <string>
#include <vector>

#include "tests/cli_program.h"

namespace stream_recon {
namespace {

nlohmann::json solid_of(const CommandFolder& folder, const std::string& arguments) {
  const Outcome outcome =
      folder.run("stream-recon " + arguments + " -o out.ply --report out.json --progress none");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.error;
  return folder.json("out.json")["surface"];
}

void make(const CommandFolder& folder, const std::string& arguments) {
  const Outcome outcome = folder.run("make-cloud " + arguments);
  ASSERT_EQ(outcome.exit_code, 0) << outcome.error;
}

void put_points(const CommandFolder& folder, const std::string& name,
                const std::vector<std::array<double, 3>>& points) {
  std::ofstream out(folder.path(name));
  out.precision(17);
  for (const auto& p : points) out << p[0] << ' ' << p[1] << ' ' << p[2] << '\n';
}

TEST(Solid, OfOneTetrahedronIsItsFourTrianglesOrNothing) {
  const CommandFolder folder;
  put_points(folder, "one.xyz", {{{0, 0, 0}}, {{1, 0, 0}}, {{0, 1, 0}}, {{0, 0, 1}}});
  const auto surface = solid_of(folder, "one.xyz");
  EXPECT_EQ(surface["boundary_edges"], 0);
  EXPECT_TRUE(surface["triangles"] == 4 || surface["triangles"] == 0);
}

TEST(Solid, OfTheSpongeHasItsFortyTwoHandles) {
  const CommandFolder folder;
  make(folder, "sponge -n 60000 -o cloud.ply");
  const auto surface = solid_of(folder, "cloud.ply --memory 128M");
  EXPECT_EQ(surface["boundary_edges"], 0);
  EXPECT_NEAR(surface["euler"].get<double>(), -82, 8);
  EXPECT_GE(surface["samples_on_surface"], 60000 * 0.995);
}

TEST(Solid, OfRoundedFoldsHasExactlyItsHandlesIfSamplesAreClean) {
  const CommandFolder folder;
  for (const std::string samples : {"random", "crossings --slice-step 2"}) {
    make(folder, "folds -n 60000 --sampling " + samples + " -o cloud.ply");
    const auto surface = solid_of(folder, "cloud.ply --memory 128M");
    EXPECT_EQ(surface["boundary_edges"], 0) << samples;
    EXPECT_EQ(surface["nonmanifold_edges"], 0) << samples;
    EXPECT_EQ(surface["components"], 1) << samples;
    EXPECT_EQ(surface["euler"], -82) << samples;
    EXPECT_GE(surface["samples_on_surface"], 60000 * 0.998) << samples;
  }
}

TEST(Solid, OfRoundedFoldsHasNearlyItsHandlesOnVoxelsAndInNoise) {
  const CommandFolder folder;
  for (const std::string samples : {"noisy", "faces --slice-step 1", "faces --slice-step 2",
                                    "centres --slice-step 1", "centres --slice-step 2"}) {
    make(folder, "folds -n 60000 --sampling " + samples + " -o cloud.ply");
    const auto surface = solid_of(folder, "cloud.ply --memory 128M");
    EXPECT_EQ(surface["boundary_edges"], 0) << samples;
    EXPECT_NEAR(surface["euler"].get<double>(), -82, 8) << samples;
  }
}

TEST(Solid, OfSmoothBodiesGoesThroughEverySample) {
  const CommandFolder folder;
  for (const std::string cloud : {"blob -n 20000", "blob -n 20000 --sampling crossings",
                                  "blob -n 20000 --sampling faces --slice-step 4"}) {
    make(folder, cloud + " -o cloud.pts");  // carries the grid's spacing
    const auto surface = solid_of(folder, "cloud.pts");
    EXPECT_EQ(surface["boundary_edges"], 0) << cloud;
    EXPECT_EQ(surface["nonmanifold_edges"], 0) << cloud;
    EXPECT_EQ(surface["euler"], 2) << cloud;
    EXPECT_EQ(surface["unused_samples"], 0) << cloud;
  }
}

TEST(Solid, OfACavityAndOfABodyInsideKeepsBoth) {
  const CommandFolder folder;
  make(folder, "nested -n 12000 --sampling noisy --noise 0.05 -o cloud.ply");
  const auto surface = solid_of(folder, "cloud.ply");
  EXPECT_EQ(surface["boundary_edges"], 0);
  EXPECT_EQ(surface["components"], 2);
  EXPECT_EQ(surface["cavities"], 1);
  EXPECT_EQ(surface["euler"], 6);
}

TEST(Solid, LeavesOutliersFarAwayAlone) {
  const CommandFolder folder;
  make(folder, "blob -n 5000 -o cloud.ply");
  put_points(folder, "far.xyz", {{{90, 0, 0}}, {{0, -70, 10}}, {{-20, 40, 60}}, {{1, 2, -300}}});
  const auto alone = solid_of(folder, "cloud.ply");
  const auto together = solid_of(folder, "cloud.ply far.xyz --unused unused.ply");
  EXPECT_EQ(together["boundary_edges"], 0);
  EXPECT_NEAR(together["volume"].get<double>(), alone["volume"].get<double>(), 0.01);
  EXPECT_GE(together["unused_samples"], 3);
}

TEST(Solid, OfAnOpenHemisphereIsClosedUnlessOpeningsAreAskedFor) {
  const CommandFolder folder;
  std::mt19937_64 random(3);
  std::normal_distribution<double> normal;
  std::vector<std::array<double, 3>> points;
  while (points.size() < 4000) {
    std::array<double, 3> p{normal(random), normal(random), std::abs(normal(random))};
    const double length = std::hypot(p[0], p[1], p[2]);
    for (double& x : p) x /= length;
    p[2] *= 0.8;  // on no sphere
    points.push_back(p);
  }
  put_points(folder, "half.xyz", points);
  const auto closed = solid_of(folder, "half.xyz");
  EXPECT_EQ(closed["boundary_edges"], 0);
  EXPECT_EQ(closed["euler"], 2);
  const auto open = solid_of(folder, "half.xyz --open 3");
  EXPECT_GT(open["boundary_edges"], 10);
  EXPECT_LT(open["triangles"], closed["triangles"]);
}

TEST(Solid, IsTheSameForAnyMemoryAndThreads) {
  const CommandFolder folder;
  make(folder, "folded -n 120000 --sampling centres --slice-step 2 -o cloud.ply");
  const std::string options = "stream-recon cloud.ply --chunk-points 30000 --progress none ";
  ASSERT_EQ(folder.run(options + "-o first.ply --memory 1G").exit_code, 0);
  for (const std::string resources :
       {"--memory 64M --threads 1", "--memory 72M --threads 2", "--memory 300M --threads 3"}) {
    const Outcome outcome = folder.run(options + resources + " -o next.ply");
    ASSERT_EQ(outcome.exit_code, 0) << resources << outcome.error;
    EXPECT_TRUE(folder.bytes("next.ply") == folder.bytes("first.ply")) << resources;
  }
}

class RealSolid : public testing::TestWithParam<std::string> {};

TEST_P(RealSolid, IsClosedAndFacesOutward) {
  const std::string input = STREAM_RECON_SHARED_DATA "/clouds/" + GetParam() + ".ply";
  if (!std::filesystem::exists(input)) GTEST_SKIP() << "no " << input;
  const CommandFolder folder;
  const auto surface = solid_of(folder, "'" + input + "' --memory 256M");
  EXPECT_EQ(surface["boundary_edges"], 0);
  EXPECT_GT(surface["volume"], 0);
  const Outcome check = folder.run("mesh-check out.ply --require closed");
  EXPECT_EQ(check.exit_code, 0) << check.out << check.error;
}

INSTANTIATE_TEST_SUITE_P(Real, RealSolid,
                         testing::Values("bunny", "armadillo", "lucy", "vhf_foot_bones"));

}  // namespace
}  // namespace stream_recon
