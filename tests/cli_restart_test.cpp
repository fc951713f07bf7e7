// Runs that end early and go on, as a user sees them: exit codes, messages, pipes.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "tests/cli_program.h"

namespace stream_recon {
namespace {

using testing::AllOf;
using testing::HasSubstr;

const char* const kOptions = " --memory 64M --threads 1 --scratch . ";

class CliRestart : public testing::Test {
 protected:
  void SetUp() override {
    const std::string fine = std::string("stream-recon big.ply -o fine/out.ply") + kOptions;
    ASSERT_EQ(folder_.run("make-cloud folded -n 80000 -o big.ply; mkdir fine; " + fine).exit_code,
              0);
  }

  /// Runs until progress shows the first finished window, then signals. \param input redirections
  Outcome stop(const std::string& signal, const std::string& input) const {
    // A shell's background jobs ignore SIGINT unless told otherwise. What an earlier run said must
    // be gone before this one is waited for.
    return folder_.run("rm -f progress; env --default-signal=INT stream-recon " + input + kOptions +
                       "-o out.ply --progress json 2>progress & run=$!\n"
                       "until grep -qs 'delaunay\",\"done\":[1-9]' progress; do sleep 0.02; done\n"
                       "kill -" +
                       signal + " $run; wait $run");
  }

  void expect_goes_on(const std::string& input) const {
    const Outcome resumed =
        folder_.run("stream-recon " + input + kOptions + "-o out.ply --resume --report r.json");
    EXPECT_EQ(resumed.exit_code, 0) << resumed.error;
    EXPECT_EQ(resumed.error, "");
    EXPECT_TRUE(folder_.bytes("out.ply") == folder_.bytes("fine/out.ply"));
    const nlohmann::json report = folder_.json("r.json");
    for (const auto& stage : report.at("stages")) {
      EXPECT_NE(stage.at("name"), "ingest");
      EXPECT_NE(stage.at("name"), "order");
    }
    folder_.run("rm out.ply r.json");
    for (const std::string& name : folder_.names()) {
      EXPECT_EQ(name.find(".partial-"), std::string::npos) << name;
    }
  }

  CommandFolder folder_;
};

TEST_F(CliRestart, SignalsAfterTheFirstWindowEndTheRunWith75) {
  for (const std::string signal : {"INT", "TERM"}) {
    SCOPED_TRACE(signal);
    EXPECT_EQ(stop(signal, "big.ply").exit_code, 75);
    EXPECT_THAT(folder_.bytes("progress"), HasSubstr("with --resume to go on"));
    EXPECT_FALSE(folder_.has("out.ply"));
    expect_goes_on("big.ply");
  }
}

TEST_F(CliRestart, PointsFromAPipeAreNotAskedForTwice) {
  EXPECT_EQ(stop("KILL", "- <big.ply").exit_code, 128 + 9);
  EXPECT_FALSE(folder_.has("out.ply"));
  expect_goes_on("- </dev/null");
}

TEST_F(CliRestart, AFullDiskAtTheEndLosesNothing) {
  const Outcome full =
      folder_.run(std::string("stream-recon big.ply -o -") + kOptions + ">/dev/full");
  EXPECT_EQ(full.exit_code, 74);
  EXPECT_THAT(full.error, AllOf(HasSubstr("standard output"), HasSubstr("add --resume")));
  EXPECT_EQ(std::count(full.error.begin(), full.error.end(), '\n'), 1) << full.error;
  const Outcome resumed =
      folder_.run(std::string("stream-recon big.ply -o - --resume") + kOptions + ">out.ply");
  EXPECT_EQ(resumed.exit_code, 0) << resumed.error;
  EXPECT_TRUE(folder_.bytes("out.ply") == folder_.bytes("fine/out.ply"));
}

TEST_F(CliRestart, WithAnotherInputOrOptionIsRefusedInOneLine) {
  ASSERT_EQ(stop("KILL", "big.ply").exit_code, 128 + 9);
  const std::string again = std::string("stream-recon big.ply -o out.ply --resume") + kOptions;
  const Outcome option = folder_.run(again + "--open 4");
  EXPECT_EQ(option.exit_code, 64);
  EXPECT_THAT(option.error, HasSubstr("cannot resume: --open: nothing then, 4 now"));
  EXPECT_EQ(folder_.run("make-cloud folded -n 80001 -o big.ply").exit_code, 0);
  const Outcome input = folder_.run(again);
  EXPECT_EQ(input.exit_code, 65);
  EXPECT_THAT(input.error, HasSubstr("cannot resume: input 1"));
  for (const Outcome& outcome : {option, input}) {
    EXPECT_EQ(std::count(outcome.error.begin(), outcome.error.end(), '\n'), 1) << outcome.error;
  }
}

}  // namespace
}  // namespace stream_recon
