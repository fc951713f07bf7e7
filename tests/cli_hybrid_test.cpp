// The hybrid, as a run leaves it.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "tests/cli_program.h"

namespace stream_recon {
namespace {

using testing::HasSubstr;

TEST(Hybrid, IsWrittenInEveryFormatWithTheSameTriangles) {
  const CommandFolder folder;
  ASSERT_EQ(folder.run("make-cloud folds -n 6000 -o cloud.ply").exit_code, 0);
  for (const std::string name : {"out.ply", "out.pvtp", "out.vtk"}) {
    SCOPED_TRACE(name);
    std::string commands = "stream-recon cloud.ply --surface hybrid --chunk-points 900 -o ";
    commands.append(name).append(" --report r.json && mesh-check ").append(name);
    commands += " --require oriented,no-duplicate --json >m.json";
    const Outcome outcome = folder.run(commands);
    ASSERT_EQ(outcome.exit_code, 0) << outcome.error;
    const auto report = folder.json("r.json");
    const auto mesh = folder.json("m.json");
    EXPECT_EQ(report["surface"]["kind"], "hybrid");
    EXPECT_EQ(mesh["vertices"], report["surface"]["vertices"]);
    EXPECT_EQ(mesh["triangles"], report["surface"]["triangles"]);
    EXPECT_EQ(mesh["boundary_edges"], report["surface"]["boundary_edges"]);
    EXPECT_GT(report["surface"]["samples_on_surface"], 5900);
    EXPECT_EQ(report["hybrid"]["added_vertices"], 0);
    EXPECT_GT(report["hybrid"]["holes"], 100);
    EXPECT_EQ(report["hybrid"]["by_solid"], 0);
    EXPECT_EQ(report["power"]["guests"].is_number(), true);
  }
}

TEST(Hybrid, IsClosedWhereTheSolidFillsWhatNoPatchCloses) {
  const CommandFolder folder;
  ASSERT_EQ(
      folder.run("make-cloud folded -n 4000 -o a.ply && make-cloud cube -n 500 -o b.ply").exit_code,
      0);
  const Outcome outcome = folder.run(
      "stream-recon a.ply b.ply --surface hybrid --fill solid -o out.ply --report r.json && "
      "mesh-check out.ply --require closed,oriented");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.error << outcome.out;
  EXPECT_EQ(folder.json("r.json")["hybrid"]["left_out"], 0);
  EXPECT_EQ(folder.json("r.json")["surface"]["boundary_edges"], 0);
}

TEST(Hybrid, RefusesWhatItHasNotInOneLine) {
  const CommandFolder folder;
  ASSERT_EQ(folder.run("make-cloud blob -n 500 -o cloud.ply && make-cloud plane -n 50 -o plane.ply")
                .exit_code,
            0);
  const std::vector<std::string> before = folder.names();
  struct Refusal {
    std::string arguments;
    int exit_code;
    std::string says;
  };
  const std::vector<Refusal> refusals{
      {"--surface hybrid cloud.ply -o o.ply --unused u.ply", 64, "--unused"},
      {"--surface hybrid cloud.ply -o o.ply --open 4", 64, "--open"},
      {"--surface hybrid cloud.ply -o o.ply --manifold", 64, "--manifold"},
      {"--surface hybrid cloud.ply -o o.ply --delta-max 60", 64, "--delta-max"},
      {"--surface hybrid cloud.ply -o o.ply --fill crust", 64, "--fill"},
      {"--surface solid cloud.ply -o o.ply --fill solid", 64, "--fill is for --surface hybrid"},
      {"--surface hybrid cloud.ply -o o.ply --medial-axis a.pvtp --medial-axis-faces", 64,
       "--medial-axis-faces"},
      {"--surface hybrid cloud.ply", 64, "-o OUT.pvtp"},
      {"--surface hybrid plane.ply -o o.ply", 65, "in one plane"},
      {"--surface hybrid - -o o.ply --input-format xyz </dev/null", 65, "0 distinct points"},
  };
  for (const Refusal& refusal : refusals) {
    SCOPED_TRACE(refusal.arguments);
    const Outcome outcome = folder.run("stream-recon " + refusal.arguments);
    EXPECT_EQ(outcome.exit_code, refusal.exit_code) << outcome.error;
    EXPECT_THAT(outcome.error, HasSubstr(refusal.says));
    EXPECT_EQ(std::count(outcome.error.begin(), outcome.error.end(), '\n'), 1) << outcome.error;
    EXPECT_EQ(folder.names(), before);
  }
}

TEST(Hybrid, ComesWithItsMedialAxis) {
  const CommandFolder folder;
  ASSERT_EQ(folder.run("make-cloud folds -n 3000 -o cloud.ply").exit_code, 0);
  const Outcome both = folder.run(
      "stream-recon cloud.ply --surface hybrid -o out.ply --medial-axis axis.pvtp --html "
      "page.html");
  ASSERT_EQ(both.exit_code, 0) << both.error;
  EXPECT_THAT(folder.bytes("page.html"), HasSubstr("<h2>Holes</h2>"));
  EXPECT_FALSE(list_folder(folder.path("axis")).empty());
  const std::string bytes = folder.bytes("out.ply");
  ASSERT_EQ(folder.run("stream-recon cloud.ply --surface hybrid -o alone.ply").exit_code, 0);
  EXPECT_TRUE(folder.bytes("alone.ply") == bytes);
}

}  // namespace
}  // namespace stream_recon
