// What is shown while a run lasts, and stopping it.

#include "engine/progress.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <string>
#include <thread>

#include "engine/interrupt.h"
#include "engine/parallel.h"

namespace stream_recon {
namespace {

using testing::HasSubstr;

/// What a progress of the given style prints for one stage.
std::string shown(ProgressStyle style, std::uint64_t total) {
  std::FILE* const file = std::tmpfile();
  {
    Progress progress(style, file);
    progress.begin_stage("order", total, "points");
    parallel_for_ranges(1000, 10, [&progress](std::size_t begin, std::size_t end) {
      progress.advance(end - begin);
    });
    progress.end_stage();
  }
  std::string text(static_cast<std::size_t>(std::ftell(file)), '\0');
  std::rewind(file);
  EXPECT_EQ(std::fread(text.data(), 1, text.size(), file), text.size());
  std::fclose(file);
  return text;
}

TEST(Progress, JsonLinesHaveRateAndTimeLeft) {
  const std::string text = shown(ProgressStyle::kJson, 4000);
  ASSERT_FALSE(text.empty());
  const std::size_t last = text.rfind('\n', text.size() - 2) + 1;
  const auto line = nlohmann::json::parse(text.substr(last));
  EXPECT_EQ(line.at("stage"), "order");
  EXPECT_EQ(line.at("done"), 1000);
  EXPECT_EQ(line.at("total"), 4000);
  EXPECT_EQ(line.at("unit"), "points");
  EXPECT_GT(line.at("rate").get<double>(), 0);
  EXPECT_NEAR(line.at("seconds_left").get<double>(), 3 * line.at("seconds").get<double>(), 1e-6);
}

TEST(Progress, TimeLeftIsWhatItIsToldToExpect) {
  std::FILE* const file = std::tmpfile();
  {
    Progress progress(ProgressStyle::kJson, file);
    progress.begin_stage("delaunay", 100, "points");
    progress.expect(1000);
    progress.note("disk: plenty");
    progress.end_stage();
  }
  std::string text(static_cast<std::size_t>(std::ftell(file)), '\0');
  std::rewind(file);
  ASSERT_EQ(std::fread(text.data(), 1, text.size(), file), text.size());
  std::fclose(file);
  const std::size_t last = text.rfind('\n', text.size() - 2) + 1;
  EXPECT_NEAR(nlohmann::json::parse(text.substr(last)).at("seconds_left").get<double>(), 1000, 30);
  EXPECT_THAT(text, HasSubstr("{\"note\":\"disk: plenty\"}\n"));
}

TEST(Progress, BarEndsItsLine) {
  const std::string text = shown(ProgressStyle::kBar, 1000);
  EXPECT_THAT(text, HasSubstr("100 %"));
  EXPECT_THAT(text, HasSubstr("points/s"));
  EXPECT_EQ(text.back(), '\n');
}

TEST(Progress, AutoIsSilentWhereNobodyWatches) {
  EXPECT_EQ(shown(ProgressStyle::kAuto, 1000), "");
  EXPECT_EQ(shown(ProgressStyle::kNone, 1000), "");
}

/// Exit code 0 iff the request is made within a second of the signal.
void watch_a_signal() {
  StopRequest stop;
  const SignalWatch watch(stop);
  if (stop.requested()) std::_Exit(2);
  kill(getpid(), SIGTERM);
  for (int i = 0; i < 100 && !stop.requested(); ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  std::_Exit(stop.requested() ? 0 : 1);
}

TEST(SignalWatchDeathTest, TurnsASignalIntoARequest) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  EXPECT_EXIT(watch_a_signal(), testing::ExitedWithCode(0), "");
}

TEST(SignalWatchDeathTest, EndsARunThatDoesNotLook) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  EXPECT_EXIT(
      {
        StopRequest stop;
        const SignalWatch watch(stop);
        kill(getpid(), SIGINT);
        for (;;) std::this_thread::sleep_for(std::chrono::seconds(1));
      },
      testing::ExitedWithCode(130), "interrupted");
}

TEST(StopRequest, ThrowsOnceMade) {
  StopRequest stop;
  EXPECT_NO_THROW(stop.check());
  stop.request();
  EXPECT_THROW(stop.check(), Interrupted);
}

}  // namespace
}  // namespace stream_recon
