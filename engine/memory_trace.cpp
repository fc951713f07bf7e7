#include "engine/memory_trace.h"

#include <pthread.h>

#include <algorithm>
#include <cmath>
#include <csignal>

#include "engine/process_memory.h"

namespace stream_recon {
namespace {

constexpr auto kInterval = std::chrono::milliseconds(20);

/// Signals are for the threads that wait for them: a thread inherits the mask it is made under.
class NoSignals {
 public:
  NoSignals() {
    sigset_t all;
    sigfillset(&all);
    pthread_sigmask(SIG_SETMASK, &all, &before_);
  }
  ~NoSignals() { pthread_sigmask(SIG_SETMASK, &before_, nullptr); }
  NoSignals(const NoSignals&) = delete;
  NoSignals& operator=(const NoSignals&) = delete;

 private:
  sigset_t before_{};
};

const MemorySample& larger(const MemorySample& a, const MemorySample& b) {
  return b.resident_bytes > a.resident_bytes ? b : a;
}

}  // namespace

void SampleThinner::add(const MemorySample& sample) {
  if (samples_.size() == most_) {
    for (std::size_t i = 0; i < most_ / 2; ++i) {
      samples_[i] = larger(samples_[2 * i], samples_[2 * i + 1]);
    }
    samples_.resize(most_ / 2);
    stretch_ *= 2;
  }
  samples_.push_back(sample);
}

MemoryTrace::MemoryTrace() {
  thinner_.add(look());
  const NoSignals mask;
  thread_ = std::thread([this] { watch(); });
}

MemoryTrace::~MemoryTrace() {
  end();
}

std::vector<MemorySample> MemoryTrace::stop() {
  end();
  thinner_.add(look());
  return thinner_.samples();
}

void MemoryTrace::end() {
  if (!thread_.joinable()) return;
  {
    const std::lock_guard lock(mutex_);
    stopping_ = true;
  }
  wake_.notify_one();
  thread_.join();
}

void MemoryTrace::watch() {
  std::unique_lock lock(mutex_);
  const auto is_stopping = [this] { return stopping_; };
  while (!wake_.wait_for(lock, kInterval * thinner_.stretch(), is_stopping)) thinner_.add(look());
}

MemorySample MemoryTrace::look() const {
  const double seconds = std::chrono::duration<double>(Clock::now() - began_).count();
  return {std::round(seconds * 1000) / 1000, resident_bytes()};
}

}  // namespace stream_recon
