// The tetrahedra as another program finds them: all of them, whatever the resources of the run.

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/cli_program.h"

namespace stream_recon {
namespace {

struct Cloud {
  std::string kind;
  std::string options;
  std::string chunks;
};

void PrintTo(const Cloud& cloud, std::ostream* out) {
  *out << cloud.kind << " " << cloud.options;
}

class Tetrahedra : public testing::TestWithParam<Cloud> {};

// 20,000 points make arrays of more than one compressed block.
TEST_P(Tetrahedra, AreReadByVtkAsTheReportCountsThem) {
  const CommandFolder folder;
  ASSERT_EQ(folder.run("make-cloud " + GetParam().kind + " -o cloud.f64").exit_code, 0);
  const Outcome outcome = folder.run("stream-recon cloud.f64 --tetrahedra t.pvtu --report r.json " +
                                     GetParam().options);
  ASSERT_EQ(outcome.exit_code, 0) << outcome.error;
  const Outcome read = folder.run(
      STREAM_RECON_VTK_PYTHON " " STREAM_RECON_TESTS "/cli_tetrahedra_check.py t.pvtu cloud.f64");
  // 77 is the script's word for a missing VTK, 127 the shell's for a missing Python.
  if (read.exit_code == 77 || read.exit_code == 127) GTEST_SKIP() << "install python3-vtk9";
  ASSERT_EQ(read.exit_code, 0) << read.out << read.error;

  const auto found = nlohmann::json::parse(read.out);
  const auto delaunay = folder.json("r.json")["delaunay"];
  EXPECT_EQ(found["cells"], delaunay["tetrahedra"]);
  EXPECT_EQ(found["cells_by_index"], delaunay["tetrahedra"]);
  EXPECT_EQ(found["digest"], delaunay["digest"]);
  EXPECT_EQ(found["not_positive"], 0);
  EXPECT_EQ(found["unused_points"], 0);
  EXPECT_EQ(found["chunks"].dump(), GetParam().chunks);
}

INSTANTIATE_TEST_SUITE_P(Clouds, Tetrahedra,
                         testing::Values(Cloud{"cube -n 20000", "--surface none", "1"},
                                         Cloud{"cube -n 3000", "-o s.pvtp --chunk-points 400", "8"},
                                         Cloud{"shell -n 5000", "-o s.ply --chunk-points 900", "6"},
                                         Cloud{"folded -n 4000",
                                               "-o s.vtk --surface alpha --alpha 0.1", "1"}));

TEST(TetrahedraBytes, AreTheSameForEveryBudgetAndThreadCount) {
  const CommandFolder folder;
  ASSERT_EQ(folder.run("make-cloud folded -n 60000 -o cloud.ply").exit_code, 0);
  const std::string run = "stream-recon cloud.ply --chunk-points 9000 ";
  ASSERT_EQ(folder.run(run + "--surface none --tetrahedra first.pvtu").exit_code, 0);
  const std::string first = folder.chunked_bytes("first", ".pvtu");
  EXPECT_GT(first.size(), std::size_t{1} << 20);
  for (const std::string options :
       {"--threads 1 --surface none", "--threads 3 -o s.pvtp", "--memory 80M -o s.ply"}) {
    const Outcome outcome =
        folder.run("rm -rf next next.pvtu; " + run + "--tetrahedra next.pvtu " + options);
    ASSERT_EQ(outcome.exit_code, 0) << outcome.error;
    EXPECT_EQ(folder.chunked_bytes("next", ".pvtu") == first, true) << options;
  }
}

TEST(TetrahedraFiles, AreTheIndexAndItsFolderAndTheSurfaceIsAsWithoutThem) {
  const CommandFolder folder;
  ASSERT_EQ(folder.run("make-cloud cube -n 2000 -o cloud.ply").exit_code, 0);
  ASSERT_EQ(folder.run("stream-recon cloud.ply --surface none --tetrahedra t.pvtu").exit_code, 0);
  EXPECT_EQ(folder.names(), (std::vector<std::string>{"cloud.ply", "t", "t.pvtu"}));
  ASSERT_EQ(folder.run("stream-recon cloud.ply -o s.ply").exit_code, 0);
  ASSERT_EQ(folder.run("stream-recon cloud.ply -o b.ply --tetrahedra t.pvtu").exit_code, 0);
  EXPECT_EQ(folder.names(),
            (std::vector<std::string>{"b.ply", "cloud.ply", "s.ply", "t", "t.pvtu"}));
  EXPECT_EQ(folder.bytes("s.ply") == folder.bytes("b.ply"), true);
}

TEST(TetrahedraFiles, OfACloudLargerThanTheMemoryKeepToIt) {
  const CommandFolder folder;
  ASSERT_EQ(folder.run("make-cloud cube -n 250000 -o cloud.ply").exit_code, 0);
  const Outcome outcome = folder.run(
      "stream-recon cloud.ply --surface none --tetrahedra t.pvtu --report r.json --memory 64M");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.error;
  const auto report = folder.json("r.json");
  EXPECT_GT(report["windows"]["count"], 2);
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
  EXPECT_LE(report["peak_rss_bytes"], report["memory_budget_bytes"]);
#endif
}

TEST(TetrahedraFiles, OfAFolderThatHoldsOtherThingsAreRefusedAndNothingIsTouched) {
  const CommandFolder folder;
  ASSERT_EQ(folder.run("make-cloud cube -n 2000 -o cloud.ply").exit_code, 0);
  ASSERT_EQ(folder.run("stream-recon cloud.ply -o a.pvtp").exit_code, 0);
  const std::string surface = folder.chunked_bytes("a", ".pvtp");
  const Outcome refused = folder.run("stream-recon cloud.ply --surface none --tetrahedra a.pvtu");
  EXPECT_EQ(refused.exit_code, 74);
  EXPECT_NE(refused.error.find("it holds chunk_000000.vtp"), std::string::npos) << refused.error;
  EXPECT_EQ(folder.chunked_bytes("a", ".pvtp") == surface, true);
  EXPECT_EQ(folder.names(), (std::vector<std::string>{"a", "a.pvtp", "cloud.ply"}));
}

}  // namespace
}  // namespace stream_recon
