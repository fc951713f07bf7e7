// Notes what each stage of a run took.
//
// Thread rule: one thread. Memory: a few words a stage.
#pragma once

#include <chrono>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "engine/report.h"
#include "io/file.h"

namespace stream_recon {

class StageLog {
 public:
  /// Runs `work` as the stage `name` and returns its result.
  template <class Work>
  auto run(std::string name, const Work& work) {
    const Stage stage(stages_, std::move(name), seconds());
    return work();
  }

  /// Bytes that the last stage read from elsewhere than a File.
  void add_bytes_read(std::uint64_t bytes) { stages_.back().bytes_read += bytes; }

  const std::vector<StageReport>& stages() const { return stages_; }
  double seconds() const { return seconds_since(began_); }

 private:
  using Clock = std::chrono::steady_clock;

  static double seconds_since(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
  }

  class Stage {
   public:
    Stage(std::vector<StageReport>& stages, std::string name, double start_seconds)
        : stages_(stages), name_(std::move(name)), start_seconds_(start_seconds) {}
    ~Stage() {
      const IoTotals now = io_totals();
      stages_.push_back({std::move(name_), start_seconds_, seconds_since(began_),
                         now.bytes_read - before_.bytes_read,
                         now.bytes_written - before_.bytes_written});
    }
    Stage(const Stage&) = delete;
    Stage& operator=(const Stage&) = delete;

   private:
    std::vector<StageReport>& stages_;
    std::string name_;
    double start_seconds_;
    IoTotals before_ = io_totals();
    Clock::time_point began_ = Clock::now();
  };

  Clock::time_point began_ = Clock::now();
  std::vector<StageReport> stages_;
};

}  // namespace stream_recon
