// The power crust, as a run leaves it.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "tests/cli_program.h"

namespace stream_recon {
namespace {

using testing::HasSubstr;

TEST(Crust, IsWrittenInEveryFormatWithTheSameTriangles) {
  const CommandFolder folder;
  ASSERT_EQ(folder.run("make-cloud blob -n 3000 -o cloud.ply").exit_code, 0);
  for (const std::string name : {"out.ply", "out.pvtp", "out.vtk"}) {
    SCOPED_TRACE(name);
    std::string commands = "stream-recon cloud.ply --surface crust --chunk-points 900 -o ";
    commands.append(name).append(" --report r.json && mesh-check ").append(name);
    commands += " --require closed,oriented,no-duplicate --json >m.json";
    const Outcome outcome = folder.run(commands);
    ASSERT_EQ(outcome.exit_code, 0) << outcome.error;
    const auto report = folder.json("r.json");
    const auto mesh = folder.json("m.json");
    EXPECT_EQ(report["surface"]["kind"], "crust");
    EXPECT_EQ(report["surface"]["boundary_edges"], 0);
    EXPECT_EQ(mesh["vertices"], report["surface"]["vertices"]);
    EXPECT_EQ(mesh["triangles"], report["surface"]["triangles"]);
    EXPECT_EQ(mesh["euler"], 2);
    EXPECT_GT(report["surface"]["samples_on_surface"], 2400);
    EXPECT_EQ(report["power"]["poles"], report["poles"]["inner"]);
  }
}

TEST(Crust, SplitIsAManifold) {
  const CommandFolder folder;
  ASSERT_EQ(folder
                .run("make-cloud folded -n 3000 -o a.ply && "
                     "make-cloud cube -n 500 -o b.ply")
                .exit_code,
            0);
  const Outcome outcome = folder.run(
      "stream-recon a.ply b.ply --surface crust --manifold -o out.ply && "
      "mesh-check out.ply --require closed,manifold,oriented");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.error << outcome.out;
}

TEST(Crust, OfVoxelsWithCornersInOnePlaceIsSplitIntoAManifold) {
  const CommandFolder folder;
  for (const std::string cloud : {"blob -n 3000 --sampling faces", "folds -n 5000 --sampling faces",
                                  "blob -n 2000 --sampling centres"}) {
    SCOPED_TRACE(cloud);
    const Outcome outcome = folder.run(
        "make-cloud " + cloud +
        " --slice-step 1 -o cloud.pts && "
        "stream-recon cloud.pts --surface crust --manifold --chunk-points 5000 -o out.pvtp && "
        "mesh-check out.pvtp --require closed,manifold,oriented");
    EXPECT_EQ(outcome.exit_code, 0) << outcome.error << outcome.out;
  }
}

TEST(Crust, OfBallsMergedWithinATolerance) {
  const CommandFolder folder;
  ASSERT_EQ(folder.run("make-cloud blob -n 2000 -o cloud.ply").exit_code, 0);
  const std::string run = "stream-recon cloud.ply --surface crust -o out.ply --report r.json";
  ASSERT_EQ(folder.run(run).exit_code, 0);
  const auto plain = folder.json("r.json");
  const std::string bytes = folder.bytes("out.ply");
  ASSERT_EQ(folder.run(run + " --pole-tolerance 0").exit_code, 0);
  EXPECT_TRUE(folder.bytes("out.ply") == bytes);
  ASSERT_EQ(folder.run(run + " --pole-tolerance 0.01").exit_code, 0);
  const auto merged = folder.json("r.json");
  EXPECT_GT(merged["poles"]["coincident"], 20);
  EXPECT_EQ(merged["poles"]["count"].get<int>() + merged["poles"]["coincident"].get<int>(),
            plain["poles"]["count"].get<int>() + plain["poles"]["coincident"].get<int>());
  EXPECT_EQ(merged["power"]["poles"], merged["poles"]["inner"]);
  EXPECT_EQ(merged["surface"]["boundary_edges"], 0);
  EXPECT_EQ(merged["surface"]["euler"], 2);
  const double volume = plain["surface"]["volume"];
  EXPECT_NEAR(merged["surface"]["volume"].get<double>(), volume, 1e-3 * volume);
}

TEST(Crust, OfNoisySamplesWithoutSmallBallsIsASmoothBall) {
  const CommandFolder folder;
  ASSERT_EQ(
      folder.run("make-cloud blob -n 6000 --sampling noisy --noise 0.5 -o cloud.ply").exit_code, 0);
  const std::string run = "stream-recon cloud.ply --surface crust -o out.ply --report r.json";
  ASSERT_EQ(folder.run(run).exit_code, 0);
  const auto plain = folder.json("r.json");
  EXPECT_EQ(plain["poles"]["small"], 0);
  const std::string bytes = folder.bytes("out.ply");
  ASSERT_EQ(folder.run(run + " --least-ball 0").exit_code, 0);
  EXPECT_TRUE(folder.bytes("out.ply") == bytes);
  ASSERT_EQ(folder.run(run + " --least-ball 1").exit_code, 0);
  const auto smooth = folder.json("r.json");
  EXPECT_EQ(smooth["surface"]["euler"], 2);
  EXPECT_EQ(smooth["surface"]["boundary_edges"], 0);
  EXPECT_GT(smooth["poles"]["small"], 6000);
  EXPECT_LT(smooth["surface"]["triangles"].get<int>(),
            plain["surface"]["triangles"].get<int>() / 2);
  const double volume = plain["surface"]["volume"];
  EXPECT_NEAR(smooth["surface"]["volume"].get<double>(), volume, 0.01 * volume);
}

TEST(Crust, ComesWithItsMedialAxisAndTetrahedra) {
  const CommandFolder folder;
  ASSERT_EQ(folder.run("make-cloud blob -n 2000 -o cloud.ply").exit_code, 0);
  const Outcome both = folder.run(
      "stream-recon cloud.ply --surface crust -o out.ply --medial-axis axis.pvtp "
      "--tetrahedra t.pvtu --report r.json");
  ASSERT_EQ(both.exit_code, 0) << both.error;
  EXPECT_THAT(folder.bytes("axis.pvtp"), HasSubstr("PPolyData"));
  EXPECT_FALSE(list_folder(folder.path("axis")).empty());
  EXPECT_FALSE(list_folder(folder.path("t")).empty());
  const std::string crust = folder.bytes("out.ply");
  ASSERT_EQ(folder.run("stream-recon cloud.ply --surface crust -o alone.ply").exit_code, 0);
  EXPECT_TRUE(folder.bytes("alone.ply") == crust);
}

TEST(Crust, RefusesWhatItHasNotInOneLine) {
  const CommandFolder folder;
  ASSERT_EQ(folder
                .run("make-cloud blob -n 500 -o cloud.ply && make-cloud plane -n 50 -o plane.ply "
                     "&& make-cloud line -n 50 -o line.ply")
                .exit_code,
            0);
  const std::vector<std::string> before = folder.names();
  struct Refusal {
    std::string arguments;
    int exit_code;
    std::string says;
  };
  const std::vector<Refusal> refusals{
      {"cloud.ply -o o.ply --unused u.ply", 64, "--unused"},
      {"cloud.ply -o o.ply --open 4", 64, "--open"},
      {"cloud.ply -o o.ply --alpha 1", 64, "--alpha"},
      {"cloud.ply", 64, "-o OUT.pvtp"},
      {"plane.ply -o o.ply", 65, "in one plane"},
      {"line.ply -o o.ply", 65, "on one line"},
      {"- -o o.ply --input-format xyz </dev/null", 65, "0 distinct points"},
  };
  for (const Refusal& refusal : refusals) {
    SCOPED_TRACE(refusal.arguments);
    const Outcome outcome = folder.run("stream-recon --surface crust " + refusal.arguments);
    EXPECT_EQ(outcome.exit_code, refusal.exit_code) << outcome.error;
    EXPECT_THAT(outcome.error, HasSubstr(refusal.says));
    EXPECT_EQ(std::count(outcome.error.begin(), outcome.error.end(), '\n'), 1) << outcome.error;
    EXPECT_EQ(folder.names(), before);
  }
}

}  // namespace
}  // namespace stream_recon
