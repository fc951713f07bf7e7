// The resident memory of the process while a run lasts, as a bounded list.
//
// Guarantees: at most kMostSamples samples, ascending in time; thinning keeps the larger of two, so
// it loses no peak that was seen. Cost: a thread that wakes every 20 ms, after 10
// s every 40, and so on, and reads a small file in /proc (30 us): below a thousandth of a core.
// Memory: 16 KB. Thread rule: one owner; the samples are read after stop().
#pragma once

#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <mutex>
#include <thread>
#include <vector>

#include "engine/report.h"

namespace stream_recon {

/// Keeps at most `most` samples of any number: neighbours merge, and the stretch doubles.
class SampleThinner {
 public:
  /// \param most even, 2 or more
  explicit SampleThinner(std::size_t most) : most_(most) {}

  void add(const MemorySample& sample);
  /// How many times longer than at first the stretch of a sample is.
  std::size_t stretch() const { return stretch_; }
  const std::vector<MemorySample>& samples() const { return samples_; }

 private:
  std::size_t most_;
  std::size_t stretch_ = 1;
  std::vector<MemorySample> samples_;
};

class MemoryTrace {
 public:
  static constexpr std::size_t kMostSamples = 512;

  MemoryTrace();
  ~MemoryTrace();
  MemoryTrace(const MemoryTrace&) = delete;
  MemoryTrace& operator=(const MemoryTrace&) = delete;

  /// Takes a last sample and ends; what was seen, seconds from the construction on.
  std::vector<MemorySample> stop();

 private:
  using Clock = std::chrono::steady_clock;

  void watch();
  MemorySample look() const;
  void end();

  Clock::time_point began_ = Clock::now();
  SampleThinner thinner_{kMostSamples};
  std::mutex mutex_;
  std::condition_variable wake_;
  bool stopping_ = false;
  std::thread thread_;
};

}  // namespace stream_recon
