// mesh-check as a user calls it: exit codes, JSON, agreement with the report of the run, memory.

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <filesystem>
#include <string>

#include "tests/cli_program.h"
#include "tests/process_memory_check.h"

namespace stream_recon {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

constexpr const char* kOpenSquare =
    "printf 'ply\\nformat ascii 1.0\\nelement vertex 4\\nproperty float x\\nproperty float y\\n"
    "property float z\\nelement face 2\\nproperty list uchar int vertex_indices\\nend_header\\n"
    "0 0 0\\n1 0 0\\n1 1 0\\n0 1 0\\n3 0 1 2\\n3 0 2 3\\n' > square.ply && ";

std::string square(const std::string& command) {
  return kOpenSquare + command;
}

/// The counts that both programs make of the surface of `cloud`, in three formats.
void expect_agreement(const CommandFolder& folder, const std::string& cloud) {
  for (const std::string output : {"out.pvtp", "out.ply", "out.vtk"}) {
    SCOPED_TRACE(output);
    const Outcome outcome = folder.run("stream-recon '" + cloud + "' -o " + output +
                                       " --chunk-points 10000 --report run.json --progress none && "
                                       "mesh-check --json " +
                                       output + " > check.json");
    ASSERT_EQ(outcome.exit_code, 0) << outcome.error;
    const auto surface = folder.json("run.json")["surface"];
    const auto facts = folder.json("check.json");
    for (const char* key :
         {"triangles", "vertices", "boundary_edges", "nonmanifold_edges", "euler"}) {
      EXPECT_EQ(facts[key], surface[key]) << key;
    }
    EXPECT_EQ(facts["contradictory_ids"], 0);
    EXPECT_EQ(facts["unused_vertices"], 0);
    EXPECT_EQ(facts["degenerate_triangles"], 0);
    EXPECT_EQ(facts["duplicate_triangles"], 0);
    EXPECT_GT(facts["triangles"], 0);
  }
}

TEST(Check, AgreesWithTheReportOfTheRun) {
  const CommandFolder folder;
  ASSERT_EQ(folder.run("make-cloud folded -n 30000 -o cloud.ply").exit_code, 0);
  expect_agreement(folder, "cloud.ply");
}

TEST(Check, AgreesWithTheReportOnRealClouds) {
  const std::string clouds = STREAM_RECON_SHARED_DATA "/clouds/";
  if (!std::filesystem::exists(clouds)) GTEST_SKIP() << clouds << " is not there";
  const CommandFolder folder;
  for (const std::string name : {"lucy.ply", "vhf_foot_bones.ply"}) {
    SCOPED_TRACE(name);
    expect_agreement(folder, clouds + name);
  }
}

TEST(Check, TakesASurfaceFromAPipe) {
  const CommandFolder folder;
  const Outcome outcome = folder.run(
      "make-cloud folded -n 3000 -o - 2>/dev/null | stream-recon - -o - --report run.json "
      "--progress none | mesh-check - --json > check.json");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.error;
  EXPECT_EQ(folder.json("check.json")["triangles"],
            folder.json("run.json")["surface"]["triangles"]);
}

TEST(Check, TheJsonOfASquareIsTheOneWeKnow) {
  const CommandFolder folder;
  const Outcome outcome = folder.run(square("mesh-check square.ply --json"));
  EXPECT_EQ(outcome.exit_code, 0) << outcome.error;
  EXPECT_EQ(nlohmann::ordered_json::parse(outcome.out).dump(),
            R"({"triangles":2,"degenerate_triangles":0,"repeated_corner_triangles":0,)"
            R"("duplicate_triangles":0,"vertices":4,"unused_vertices":0,"nonmanifold_vertices":0,)"
            R"("contradictory_ids":0,"edges":5,"boundary_edges":4,"nonmanifold_edges":0,)"
            R"("wrongly_oriented_edges":0,"boundary_rings":1,"simple_boundary_rings":1,)"
            R"("closed":false,"manifold":true,"oriented":true,"components":1,)"
            R"("closed_components":0,"manifold_components":1,"oriented_components":1,)"
            R"("largest_component_triangles":2,"euler":1,"genus":null,"components_by_genus":{},)"
            R"("area":1.0,"volume":null,"box":{"low":[0.0,0.0,0.0],"high":[1.0,1.0,0.0]}})");
}

TEST(Check, RequirementsThatDoNotHoldAreExitCode1) {
  const CommandFolder folder;
  const Outcome met = folder.run(square("mesh-check square.ply --require manifold,oriented"));
  EXPECT_EQ(met.exit_code, 0) << met.error;
  EXPECT_EQ(met.error, "");
  const Outcome unmet =
      folder.run(square("mesh-check square.ply --require closed,manifold --require no-degenerate"));
  EXPECT_EQ(unmet.exit_code, 1);
  EXPECT_EQ(unmet.error, "mesh-check: square.ply: not closed: 4 boundary edges\n");
  EXPECT_THAT(unmet.out, StartsWith("triangles   2;"));
}

void expect_refusal(const CommandFolder& folder, const std::string& command, int code) {
  SCOPED_TRACE(command);
  const Outcome outcome = folder.run(square(command));
  EXPECT_EQ(outcome.exit_code, code);
  EXPECT_EQ(outcome.out, "");
  EXPECT_THAT(outcome.error, StartsWith("mesh-check: "));
  EXPECT_EQ(std::count(outcome.error.begin(), outcome.error.end(), '\n'), 1) << outcome.error;
}

TEST(Check, EveryErrorHasItsCodeAndOneLine) {
  const CommandFolder folder;
  expect_refusal(folder, "mesh-check", 64);
  expect_refusal(folder, "mesh-check square.ply --require round", 64);
  expect_refusal(folder, "mesh-check square.ply --memory much", 64);
  expect_refusal(folder, "mesh-check square.stl", 65);
  expect_refusal(folder, "head -c 170 square.ply > cut.ply; mesh-check cut.ply", 65);
  expect_refusal(folder, "mesh-check - < /dev/null", 65);
  expect_refusal(folder, "mesh-check square.ply --memory 10M", 69);
  expect_refusal(folder, "mesh-check missing.pvtp", 74);
  expect_refusal(folder, "mesh-check square.ply --scratch missing", 74);
  EXPECT_EQ(folder.run(square("mesh-check square.ply > /dev/full")).exit_code, 74);
}

TEST(Check, KeepsToItsMemory) {
  if (!kMemoryIsOurs) GTEST_SKIP() << "sanitizers need memory of their own";
  const CommandFolder folder;
  const Outcome outcome = folder.run(
      "make-cloud folded -n 250000 -o - 2>/dev/null | stream-recon - -o out.pvtp --memory 64M "
      "--progress none --chunk-points 50000 && mesh-check out.pvtp --memory 64M");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.error;
  EXPECT_THAT(outcome.out, HasSubstr("components"));
  rusage usage{};
  getrusage(RUSAGE_CHILDREN, &usage);  // the largest of all programs that ran
  EXPECT_LT(usage.ru_maxrss, 64 * 1024);
}

}  // namespace
}  // namespace stream_recon
