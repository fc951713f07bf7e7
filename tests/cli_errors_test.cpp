// Every exit code of the contract, one line for each error, and nothing half-written.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "tests/cli_program.h"

namespace stream_recon {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

struct Refusal {
  std::string arguments;
  int exit_code;
  std::string says;
};

class Refusals : public testing::Test {
 protected:
  void SetUp() override {
    ASSERT_EQ(folder_
                  .run("make-cloud cube -n 3000 -o cube.ply && head -c 500 cube.ply >cut.ply && "
                       "make-cloud line -n 50 -o line.ply && make-cloud plane -n 50 -o plane.ply")
                  .exit_code,
              0);
    before_ = folder_.names();
  }

  void expect_refused(const Refusal& refusal) const {
    SCOPED_TRACE(refusal.arguments);
    const Outcome outcome = folder_.run("stream-recon " + refusal.arguments);
    EXPECT_EQ(outcome.exit_code, refusal.exit_code) << outcome.error;
    EXPECT_THAT(outcome.error, StartsWith("stream-recon: "));
    EXPECT_THAT(outcome.error, HasSubstr(refusal.says));
    EXPECT_EQ(std::count(outcome.error.begin(), outcome.error.end(), '\n'), 1) << outcome.error;
    EXPECT_EQ(folder_.names(), before_) << "something was left behind";
  }

  CommandFolder folder_;
  std::vector<std::string> before_;
};

TEST_F(Refusals, OfUsageAre64) {
  const std::vector<Refusal> refusals{
      {"", 64, "INPUT"},
      {"cube.ply", 64, "-o OUT.pvtp"},
      {"cube.ply -o out.obj", 64, ".pvtp, .ply or .vtk"},
      {"cube.ply -o out.pvtp --frobnicate", 64, "frobnicate"},
      {"cube.ply -o out.pvtp --surface klein", 64, "--surface"},
      {"cube.ply -o out.pvtp --tetrahedra t.vtu", 64, "must end in .pvtu"},
      {"cube.ply -o out.pvtp --tetrahedra out.pvtu", 64, "one folder"},
      {"cube.ply -o ./out.pvtp --tetrahedra out.pvtu", 64, "one folder"},
      {"cube.ply -o out.pvtp --tetrahedra out/t.pvtu", 64, "one folder"},
      {"cube.ply -o t/out.ply --tetrahedra t.pvtu", 64, "one folder"},
      {"cube.ply --surface none --tetrahedra .pvtu", 64, "lacks a name"},
      {"cube.ply -o out.pvtp --unused u.xyz", 64, "must end in .ply"},
      {"cube.ply -o out.ply --unused ./out.ply", 64, "one place"},
      {"cube.ply -o out.pvtp --unused out/u.ply", 64, "one place"},
      {"cube.ply -o out.pvtp --tetrahedra t.pvtu --unused t/u.ply", 64, "one place"},
      {"cube.ply --surface none --unused u.ply", 64, "no triangles"},
      {"cube.ply -o out.pvtp --unused r.ply --report r.ply", 64, "--unused"},
      {"cube.ply -o out.pvtp --surface gamma --open 4", 64, "--surface solid"},
      {"cube.ply -o out.pvtp --surface gamma --spacing 1,1,2", 64, "--surface solid"},
      {"cube.ply -o out.pvtp --surface solid --open 0", 64, "--open"},
      {"cube.ply -o out.pvtp --surface solid --open nan", 64, "--open"},
      {"cube.ply -o out.pvtp --surface solid --spacing 1,1", 64, "--spacing"},
      {"cube.ply -o out.pvtp --surface solid --spacing 0", 64, "--spacing"},
      {"cube.ply -o out.pvtp --surface solid --spacing 1,x,1", 64, "--spacing"},
      {"cube.ply -o out.pvtp --surface solid --spacing 1,1,-2", 64, "--spacing"},
      {"cube.ply --tetrahedra t.pvtu", 64, "-o OUT.pvtp"},
      {"cube.ply -o out.pvtp --medial-axis m.ply", 64, "must end in .pvtp"},
      {"cube.ply -o out.pvtp --medial-axis out.pvtp", 64, "one folder"},
      {"cube.ply -o out.ply --medial-axis t.pvtp --tetrahedra t.pvtu", 64, "one folder"},
      {"cube.ply --surface none --medial-axis .pvtp", 64, "lacks a name"},
      {"cube.ply -o out.pvtp --surface gamma --medial-axis m.pvtp", 64,
       "--surface solid, crust, hybrid or none"},
      {"cube.ply -o a.ply --surface alpha --alpha 1 --medial-axis m.pvtp", 64,
       "solid, crust, hybrid or none"},
      {"cube.ply -o out.pvtp --medial-axis-side outer", 64, "add that"},
      {"cube.ply -o out.pvtp --medial-axis m.pvtp --medial-axis-side left", 64, "inner"},
      {"cube.ply -o out.pvtp --medial-axis m.pvtp --medial-axis-faces", 64, "crust or none"},
      {"cube.ply --surface none --medial-axis m.pvtp --medial-axis-faces --medial-axis-side both",
       64, "between inner balls"},
      {"cube.ply -o out.pvtp --surface crust --medial-axis-faces", 64, "add that"},
      {"cube.ply -o out.pvtp --pole-tolerance 1", 64, "--surface crust, hybrid and --medial-axis"},
      {"cube.ply -o out.pvtp --surface crust --pole-tolerance=-1", 64, "0 or more"},
      {"cube.ply -o out.pvtp --least-ball 1", 64, "--least-ball is for --surface crust"},
      {"cube.ply -o out.pvtp --surface crust --least-ball=-1", 64, "from 0 to 100"},
      {"cube.ply -o out.pvtp --medial-axis m.pvtp --unused m/u.ply", 64, "one place"},
      {"cube.ply --surface none --medial-axis m.pvtp --open 4", 64, "--surface solid"},
      {"cube.ply --surface none --medial-axis m.pvtp --spacing 0", 64, "--spacing"},
      {"cube.ply -o out.pvtp --surface alpha", 64, "--alpha R"},
      {"cube.ply -o out.pvtp --surface alpha --alpha -1", 64, "--alpha R"},
      {"cube.ply -o out.pvtp --surface alpha --alpha nan", 64, "--alpha R"},
      {"cube.ply -o out.pvtp --surface alpha --alpha x", 64, "--alpha"},
      {"cube.ply -o out.pvtp --alpha 1", 64, "--surface alpha"},
      {"cube.ply -o out.pvtp --surface gamma --manifold", 64, "leave --manifold out"},
      {"cube.ply -o out.pvtp --surface solid --open 4 --manifold", 64, "leave one of them out"},
      {"cube.ply -o out.pvtp --delta-max 0", 64, "--delta-max"},
      {"cube.ply -o out.pvtp --delta-max 181", 64, "--delta-max"},
      {"cube.ply -o out.pvtp --delta-max nan", 64, "--delta-max"},
      {"cube.ply -o out.pvtp --surface alpha --alpha 1 --delta-max 80", 64, "--delta-max"},
      {"cube.ply -o out.pvtp --memory lots", 64, "--memory"},
      {"cube.ply -o out.pvtp --memory 0", 64, "--memory"},
      {"cube.ply -o out.pvtp --scratch-limit -5", 64, "--scratch-limit"},
      {"cube.ply -o out.pvtp --threads 0", 64, "--threads"},
      {"cube.ply -o out.pvtp --chunk-points 0", 64, "--chunk-points"},
      {"cube.ply -o out.pvtp --progress loud", 64, "--progress"},
      {"cube.ply -o out.pvtp --input-format obj", 64, "--input-format"},
      {"- - -o out.pvtp --input-format xyz", 64, "standard input"},
      {"cube.ply -o - --report -", 64, "standard output"},
  };
  for (const Refusal& refusal : refusals) expect_refused(refusal);
}

TEST_F(Refusals, OfBadInputAre65) {
  const std::vector<Refusal> refusals{
      {"cut.ply -o out.pvtp", 65, "cut.ply"},
      {"cube.ply cut.ply -o out.pvtp", 65, "cut.ply"},
      {"line.ply -o out.pvtp", 65, "on one line"},
      {"plane.ply -o out.pvtp", 65, "in one plane"},
      {"plane.ply --surface none", 65, "in one plane"},
      {"plane.ply --surface none --medial-axis m.pvtp", 65, "in one plane"},
      {"- -o out.pvtp --input-format xyz </dev/null", 65, "0 distinct points"},
      {"- -o out.pvtp --input-format f32 </dev/null", 65, "0 distinct points"},
      {"- -o out.pvtp --input-format xyz <<'X'\n1 2 3\n1 2 3\nX", 65, "1 distinct points"},
      {"- -o out.pvtp --input-format xyz <<'X'\n1 2 3\nnan 0 0\n4 5\nX", 65, "3"},
  };
  for (const Refusal& refusal : refusals) expect_refused(refusal);
}

TEST_F(Refusals, OfTooLittleMemoryAre69WithTheLeastThatWouldDo) {
  expect_refused({"cube.ply -o out.pvtp --memory 10M", 69, "--memory 64M or more"});
  // Every facet of the cloud in one chunk.
  ASSERT_EQ(folder_.run("make-cloud folded -n 100000 -o big.ply").exit_code, 0);
  const std::string late =
      "stream-recon big.ply -o out.pvtp --surface gamma --delta-max 180 --memory ";
  const Outcome outcome = folder_.run(late + "64M");
  EXPECT_EQ(outcome.exit_code, 69);
  EXPECT_THAT(outcome.error, HasSubstr("or more"));
  // Found out late; what was done is not lost.
  EXPECT_THAT(outcome.error, HasSubstr("add --resume"));
  const Outcome resumed = folder_.run(late + "512M --resume");
  EXPECT_EQ(resumed.exit_code, 0) << resumed.error;
}

TEST_F(Refusals, OfTheSystemAre74) {
  const std::vector<Refusal> refusals{
      {"missing.ply -o out.pvtp", 74, "missing.ply"},
      {"cube.ply -o missing/out.pvtp", 74, "missing"},
      {"cube.ply -o out.pvtp --scratch missing", 74, "missing"},
      {"cube.ply -o out.pvtp --tetrahedra missing/t.pvtu", 74, "missing"},
      {"cube.ply --surface none --tetrahedra missing/t.pvtu", 74, "missing"},
      {"cube.ply -o out.pvtp --unused missing/u.ply", 74, "missing"},
      {"cube.ply --surface none --medial-axis missing/m.pvtp", 74, "missing"},
      {"cube.ply -o out.pvtp --scratch-limit 2K", 74, "limit"},
      {"cube.ply -o out.ply --report missing/report.json; code=$?; rm -f out.ply; (exit $code)", 74,
       "missing/report.json"},
  };
  for (const Refusal& refusal : refusals) expect_refused(refusal);
}

TEST_F(Refusals, LeaveAnEarlierResultAlone) {
  ASSERT_EQ(folder_.run("stream-recon cube.ply -o out.pvtp").exit_code, 0);
  const std::string index = folder_.bytes("out.pvtp");
  const std::string chunk = folder_.bytes("out/chunk_000000.vtp");
  EXPECT_EQ(folder_.run("stream-recon plane.ply -o out.pvtp").exit_code, 65);
  EXPECT_EQ(folder_.bytes("out.pvtp"), index);
  EXPECT_EQ(folder_.bytes("out/chunk_000000.vtp"), chunk);
}

TEST_F(Refusals, SignalsEndTheRunWith130AndRemoveItsFiles) {
  for (const char* signal : {"INT", "TERM"}) {
    SCOPED_TRACE(signal);
    // The input never ends, so the run is certainly under way; SIGINT is ignored in background
    // jobs of a shell, so the shell must not be in between.
    const Outcome outcome =
        folder_.run(std::string("mkfifo pipe; (cat cube.ply; sleep 20) >pipe & feeder=$!\n"
                                "timeout --preserve-status -s ") +
                    signal +
                    " 1 stream-recon pipe --input-format ply -o out.pvtp; code=$?\n"
                    "kill $feeder 2>/dev/null; rm pipe; exit $code");
    EXPECT_EQ(outcome.exit_code, 130) << outcome.error;
    EXPECT_THAT(outcome.error, HasSubstr("interrupted"));
    EXPECT_EQ(folder_.names(), before_);
  }
}

TEST_F(Refusals, OfNothingAre0) {
  for (const std::string option : {"--help", "--version"}) {
    const Outcome outcome = folder_.run("stream-recon " + option);
    EXPECT_EQ(outcome.exit_code, 0);
    EXPECT_THAT(outcome.out, HasSubstr("stream-recon"));
    EXPECT_EQ(outcome.error, "");
  }
}

}  // namespace
}  // namespace stream_recon
