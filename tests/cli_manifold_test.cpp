// A solid that touches itself, split, as a run leaves it.

#include <gtest/gtest.h>

#include <string>

#include "tests/cli_program.h"

namespace stream_recon {
namespace {

TEST(Manifold, IsTheSurfaceOfASolidWithTheSameSamplesAndTriangles) {
  const CommandFolder folder;
  // A coarse body of many handles, and noise: so that it touches itself.
  ASSERT_EQ(folder.run("make-cloud folded -n 3000 --scalar float -o a.ply").exit_code, 0);
  ASSERT_EQ(folder.run("make-cloud cube -n 3000 --scalar float -o b.ply").exit_code, 0);
  const std::string run = "stream-recon a.ply b.ply --surface solid --report r.json ";
  ASSERT_EQ(folder.run(run + "-o plain.ply --unused u.ply").exit_code, 0);
  const auto plain = folder.json("r.json")["surface"];
  ASSERT_GT(plain["nonmanifold_edges"], 0);

  const Outcome outcome =
      folder.run(run + "--manifold -o split.ply --unused v.ply --chunk-points 300");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.error;
  const auto split = folder.json("r.json")["surface"];
  EXPECT_EQ(split["nonmanifold_edges"], 0);
  EXPECT_EQ(split["boundary_edges"], 0);
  EXPECT_GT(split["vertices"], plain["vertices"]);
  for (const char* key :
       {"triangles", "digest", "samples_on_surface", "unused_samples", "volume"}) {
    EXPECT_EQ(split[key], plain[key]) << key;
  }
  EXPECT_TRUE(folder.bytes("u.ply") == folder.bytes("v.ply"));

  const std::string split_run = run + "--manifold -o ";
  for (const std::string name : {"n.ply", "n.pvtp", "n.vtk"}) {
    for (const std::string options :
         {" --threads 1 --chunk-points 300", " --memory 80M --chunk-points 300"}) {
      std::string commands = split_run;
      commands.append(name).append(options).append("; mesh-check ").append(name);
      commands += " --require closed,manifold,oriented,no-degenerate,no-duplicate --json >m.json";
      const Outcome checked = folder.run(commands);
      ASSERT_EQ(checked.exit_code, 0) << name << options << checked.error;
      if (name == "n.ply") {
        EXPECT_TRUE(folder.bytes(name) == folder.bytes("split.ply")) << options;
      }
      const auto mesh = folder.json("m.json");
      EXPECT_EQ(mesh["vertices"], split["vertices"]) << options;
      EXPECT_EQ(mesh["euler"], split["euler"]) << options;
      EXPECT_EQ(mesh["genus"], split["genus"]) << options;
      EXPECT_EQ(mesh["components"].get<int>(),
                split["components"].get<int>() + split["cavities"].get<int>())
          << options;
    }
  }
}

}  // namespace
}  // namespace stream_recon
