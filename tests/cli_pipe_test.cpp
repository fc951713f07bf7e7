// Points that come through a pipe whose writer may die at any byte.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <string>

#include "tests/cli_program.h"

namespace stream_recon {
namespace {

using testing::HasSubstr;

class Pipes : public testing::Test {
 protected:
  /// Runs a command that ends in stream-recon; it must be refused and leave nothing.
  void expect_refused(const std::string& command) const {
    SCOPED_TRACE(command);
    const Outcome outcome = folder_.run(command);
    EXPECT_EQ(outcome.exit_code, 65) << outcome.error;
    EXPECT_EQ(std::count(outcome.error.begin(), outcome.error.end(), '\n'), 1) << outcome.error;
    EXPECT_THAT(outcome.error, HasSubstr("standard input"));
    EXPECT_EQ(folder_.names(), before_) << "something was left behind";
  }

  CommandFolder folder_;
  std::vector<std::string> before_;
};

TEST_F(Pipes, GiveTheSameBytesFramedOrNot) {
  const std::string cloud = "make-cloud folded -n 20000 2>made -o - --format ";
  ASSERT_EQ(folder_.run(cloud + "pts | stream-recon - -o pts.ply --report r.json").exit_code, 0);
  ASSERT_EQ(folder_.run(cloud + "ply | stream-recon - -o ply.ply").exit_code, 0);
  EXPECT_TRUE(folder_.bytes("pts.ply") == folder_.bytes("ply.ply"));
  EXPECT_FALSE(folder_.json("r.json").at("input").contains("spacing"));
}

TEST_F(Pipes, CutAtAnyByteAreRefused) {
  ASSERT_EQ(folder_.run("make-cloud cube -n 40000 --format pts -o whole 2>made").exit_code, 0);
  before_ = folder_.names();
  const std::size_t size = folder_.bytes("whole").size();
  const unsigned seed = std::random_device{}();
  SCOPED_TRACE("seed " + std::to_string(seed));
  std::mt19937 random(seed);
  for (int round = 0; round < 40; ++round) {
    const std::size_t bytes = std::uniform_int_distribution<std::size_t>(0, size - 1)(random);
    expect_refused("head -c " + std::to_string(bytes) + " whole | stream-recon - -o out.ply");
  }
  for (const std::size_t bytes : {std::size_t{0}, std::size_t{7}, std::size_t{8}, size - 1}) {
    expect_refused("head -c " + std::to_string(bytes) + " whole | stream-recon - -o out.pvtp");
  }
}

TEST_F(Pipes, WhoseWriterIsKilledAreRefused) {
  const unsigned seed = std::random_device{}();
  SCOPED_TRACE("seed " + std::to_string(seed));
  std::mt19937 random(seed);
  for (int round = 0; round < 10; ++round) {
    const int milliseconds = std::uniform_int_distribution<int>(0, 200)(random);
    expect_refused(
        "{ make-cloud cube -n 100000000 --format pts -o - 2>/dev/null & writer=$!; sleep 0." +
        std::to_string(1000 + milliseconds).substr(1) +
        "; kill -9 $writer; wait $writer 2>/dev/null; } | stream-recon - -o out.ply");
  }
}

TEST_F(Pipes, OfATextAreNotTakenForFrames) {
  expect_refused("printf '\\211PTS\\n\\032\\n and more of it' | stream-recon - -o out.ply");
  expect_refused("echo 1 2 3 | stream-recon - --input-format pts -o out.ply");
}

}  // namespace
}  // namespace stream_recon
