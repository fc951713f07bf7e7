// Adds the processor time of this thread, from construction to destruction, to a sum.
#pragma once

#include <ctime>

namespace stream_recon {

class ThreadClock {
 public:
  explicit ThreadClock(double& seconds) : seconds_(seconds) {}
  ~ThreadClock() { seconds_ += now() - began_; }
  ThreadClock(const ThreadClock&) = delete;
  ThreadClock& operator=(const ThreadClock&) = delete;

 private:
  static double now() {
    timespec time{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
  }

  double& seconds_;
  double began_ = now();
};

}  // namespace stream_recon
