// What a run leaves: the report, the same bytes for every budget and thread count, peak memory.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <sstream>
#include <string>
#include <vector>

#include "tests/cli_program.h"
#include "tests/process_memory_check.h"

namespace stream_recon {
namespace {

using testing::HasSubstr;

TEST(Results, AreTheSameBytesForEveryBudgetAndThreadCount) {
  const CommandFolder folder;
  for (const std::string kind : {"folded", "shell"}) {
    SCOPED_TRACE(kind);
    ASSERT_EQ(folder.run("make-cloud " + kind + " -n 60000 -o cloud.ply").exit_code, 0);
    const std::string run = "stream-recon cloud.ply --chunk-points 9000 ";
    ASSERT_EQ(folder.run(run + "-o first.pvtp --report first.json").exit_code, 0);
    const std::string first = folder.chunked_bytes("first", ".pvtp");
    const auto report = folder.json("first.json");
    for (const std::string options : {"--threads 1", "--threads 2", "--threads 3", "--threads 4",
                                      "--memory 80M", "--memory 120M --threads 1", "--memory 2G"}) {
      const Outcome outcome = folder.run("rm -rf next next.pvtp; " + run +
                                         "-o next.pvtp --report next.json " + options);
      ASSERT_EQ(outcome.exit_code, 0) << outcome.error;
      EXPECT_EQ(folder.chunked_bytes("next", ".pvtp") == first, true) << options;
      for (const char* part : {"input", "delaunay", "surface"}) {
        EXPECT_EQ(folder.json("next.json")[part], report[part]) << options;
      }
    }
  }
}

TEST(Results, ProgressNamesEveryStageAndNeverPassesItsTotal) {
  const CommandFolder folder;
  const Outcome outcome = folder.run(
      "make-cloud folded -n 20000 -o cloud.ply 2>/dev/null; stream-recon cloud.ply "
      "-o out.pvtp --tetrahedra t.pvtu --chunk-points 3000 --progress json");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.error;
  std::vector<std::string> stages;
  std::istringstream lines(outcome.error);
  for (std::string line; std::getline(lines, line);) {
    const auto json = nlohmann::json::parse(line);
    if (!json.contains("stage")) continue;
    if (stages.empty() || stages.back() != json.at("stage")) stages.push_back(json.at("stage"));
    EXPECT_LE(json.at("done"), json.at("total")) << line;
  }
  EXPECT_EQ(stages,
            (std::vector<std::string>{"ingest", "order", "index", "spacing", "delaunay",
                                      "evidence, level 1", "labels", "surface", "tetrahedra"}));
}

TEST(Results, CountsDoNotDependOnTheChunks) {
  const CommandFolder folder;
  ASSERT_EQ(folder.run("make-cloud folded -n 20000 -o cloud.ply").exit_code, 0);
  nlohmann::json first;
  for (const std::string points : {"1000000", "5000", "777", "60"}) {
    const Outcome outcome = folder.run(
        "stream-recon cloud.ply -o out.pvtp --report out.json "
        "--chunk-points " +
        points);
    ASSERT_EQ(outcome.exit_code, 0) << outcome.error;
    const auto surface = folder.json("out.json")["surface"];
    if (first.is_null()) first = surface;
    EXPECT_EQ(surface, first) << points;
  }
  EXPECT_GT(first["triangles"], 30000);
}

TEST(Results, StayBelowTheMemoryTheyWereGiven) {
  if (!kMemoryIsOurs) GTEST_SKIP() << "the sanitizer's memory is not the program's";
  const CommandFolder folder;
  for (const std::string kind : {"cube", "folded", "shell", "ellipsoid"}) {
    ASSERT_EQ(folder.run("make-cloud " + kind + " -n 250000 -o cloud.ply").exit_code, 0);
    for (const std::string options : {"--memory 64M", "--memory 64M --threads 1", "--memory 96M"}) {
      SCOPED_TRACE(kind + " " + options);
      const Outcome outcome =
          folder.run("stream-recon cloud.ply -o out.pvtp --report out.json " + options);
      ASSERT_EQ(outcome.exit_code, 0) << outcome.error;
      const auto report = folder.json("out.json");
      EXPECT_LE(report["peak_rss_bytes"], report["memory_budget_bytes"]);
      EXPECT_GT(report["windows"]["count"], 2);
      EXPECT_GT(report["scratch_peak_bytes"], 0);
    }
  }
}

TEST(Results, ComeFromPipesAndSeveralInputsAlike) {
  const CommandFolder folder;
  ASSERT_EQ(folder
                .run("make-cloud cube -n 5000 -o one.ply --scalar float && "
                     "make-cloud cube -n 4000 --seed 2 -o two.f32 && "
                     "{ make-cloud cube -n 5000 -o - --format xyz --scalar float; "
                     "  make-cloud cube -n 4000 --seed 2 -o - --format f32; } >/dev/null")
                .exit_code,
            0);
  ASSERT_EQ(folder.run("stream-recon one.ply two.f32 -o a.pvtp --report a.json").exit_code, 0);
  ASSERT_EQ(folder.run("cat one.ply | stream-recon - two.f32 -o b.pvtp --report b.json").exit_code,
            0);
  const auto a = folder.json("a.json");
  EXPECT_EQ(a["input"]["points"], 9000);
  EXPECT_EQ(a["delaunay"], folder.json("b.json")["delaunay"]);
  EXPECT_EQ(a["surface"], folder.json("b.json")["surface"]);
}

TEST(Results, CountRejectedAndDuplicatePoints) {
  const CommandFolder folder;
  const Outcome outcome = folder.run(
      "stream-recon - --input-format xyz --surface alpha --alpha 10 -o out.ply --report - <<'X'\n"
      "nan 0 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n1 0 0\n0 0 inf\n-0.0 0 0\nX");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.error;
  const auto report = nlohmann::json::parse(outcome.out);
  EXPECT_EQ(report["input"]["points"], 8);
  EXPECT_EQ(report["input"]["rejected"], 2);
  EXPECT_EQ(report["input"]["duplicates"], 2);
  EXPECT_EQ(report["delaunay"]["tetrahedra"], 1);
  EXPECT_EQ(report["surface"]["triangles"], 4);
  EXPECT_EQ(report["surface"]["boundary_edges"], 0);
  EXPECT_EQ(report["surface"]["euler"], 2);
}

TEST(Results, OfNoSurfaceAreTheReportAlone) {
  const CommandFolder folder;
  ASSERT_EQ(folder.run("make-cloud cube -n 2000 -o cloud.ply").exit_code, 0);
  const Outcome outcome = folder.run("stream-recon cloud.ply --surface none --report r.json");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.error;
  EXPECT_EQ(folder.names(), (std::vector<std::string>{"cloud.ply", "r.json"}));
  EXPECT_EQ(folder.json("r.json")["surface"]["kind"], "none");
  EXPECT_GT(folder.json("r.json")["delaunay"]["tetrahedra"], 10000);
}

TEST(Results, ProgressGoesToStandardErrorOnly) {
  const CommandFolder folder;
  ASSERT_EQ(folder.run("make-cloud cube -n 2000 -o cloud.ply").exit_code, 0);
  const Outcome json = folder.run("stream-recon cloud.ply -o out.vtk --progress json");
  EXPECT_EQ(json.out, "");
  EXPECT_THAT(json.error, HasSubstr("\"stage\":\"delaunay\""));
  const Outcome silent = folder.run("stream-recon cloud.ply -o - --scratch .");
  EXPECT_EQ(silent.error, "");
  EXPECT_EQ(silent.out.substr(0, 3), "ply");
}

struct Known {
  std::string cloud;
  std::string digest;
  std::uint64_t tetrahedra;
  std::uint64_t triangles;
};

class KnownClouds : public testing::TestWithParam<Known> {};

TEST_P(KnownClouds, GiveTheirTetrahedraAndGammaTriangles) {
  const std::string input = STREAM_RECON_SHARED_DATA "/clouds/" + GetParam().cloud;
  if (!std::filesystem::exists(input)) GTEST_SKIP() << "no " << input;
  const CommandFolder folder;
  const Outcome outcome =
      folder.run("stream-recon '" + input + "' --surface gamma -o out.pvtp --report out.json");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.error;
  const auto report = folder.json("out.json");
  EXPECT_EQ(report["delaunay"]["digest"], GetParam().digest);
  EXPECT_EQ(report["delaunay"]["tetrahedra"], GetParam().tetrahedra);
  EXPECT_EQ(report["surface"]["triangles"], GetParam().triangles);
}

INSTANTIATE_TEST_SUITE_P(
    Real, KnownClouds,
    testing::Values(Known{"bunny.ply", "370c2f86a2cb7604", 246227, 66627},
                    Known{"armadillo.ply", "564c30cd7c984e21", 289478, 82047},
                    Known{"lucy.ply", "5858f4cf7b766a50", 345085, 82567},
                    Known{"vhf_foot_bones.ply", "c1df91c7ae334bb8", 1087284, 313568},
                    Known{"bunny_range_scans.ply", "0f562720f99209c6", 2251923, 374710}),
    [](const auto& test) { return test.param.cloud.substr(0, test.param.cloud.find('.')); });

}  // namespace
}  // namespace stream_recon
