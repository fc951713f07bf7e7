// What the run is doing, for the person or program that waits: on standard error only.
//
// Guarantees: at most five lines or redraws a second whatever the number of calls, one more at the
// end of each stage. Thread rule: advance() may be called from many threads; the stages are begun
// and ended by one. Cost of advance(): an atomic addition and a look at the clock.
#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <mutex>
#include <optional>
#include <string>

namespace stream_recon {

enum class ProgressStyle {
  kAuto,  ///< a bar on a terminal, nothing otherwise
  kBar,
  kJson,  ///< one object a line: stage, done, total, unit, seconds, rate, seconds_left
  kNone,
};

class Progress {
 public:
  explicit Progress(ProgressStyle style, std::FILE* out = stderr);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// \param total units of work in the stage, 0 where it is not known
  /// \param unit what is counted, in the plural: "points"
  void begin_stage(std::string name, std::uint64_t total, std::string unit);
  void advance(std::uint64_t units);
  /// The stage will take this much longer; until told, the time left is judged by the rate.
  void expect(double seconds);
  void end_stage();
  /// A line for the person or program that watches.
  void note(const std::string& text);

 private:
  using Clock = std::chrono::steady_clock;

  void show(bool last);
  void show_bar(double seconds, bool last);
  void show_json(double seconds);
  std::optional<double> seconds_left(double seconds) const;

  const ProgressStyle style_;
  std::FILE* const out_;
  std::mutex mutex_;
  std::string name_;
  std::string unit_;
  std::uint64_t total_ = 0;
  std::atomic<std::uint64_t> done_{0};
  Clock::time_point began_;
  std::optional<Clock::time_point> expected_end_;
  std::atomic<Clock::rep> next_{0};
  bool line_open_ = false;
};

}  // namespace stream_recon
