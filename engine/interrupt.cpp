#include "engine/interrupt.h"

#include <pthread.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdio>
#include <ctime>

#include "io/temporary_path.h"

namespace stream_recon {
namespace {

constexpr int kResumableExit = 75;
constexpr int kInterruptedExit = 130;
constexpr auto kGrace = std::chrono::seconds(2);
constexpr auto kPoll = std::chrono::milliseconds(50);

sigset_t watched_signals() {
  sigset_t signals;
  sigemptyset(&signals);
  sigaddset(&signals, SIGINT);
  sigaddset(&signals, SIGTERM);
  return signals;
}

bool wait_for_signal(const std::atomic<bool>& done) {
  const sigset_t signals = watched_signals();
  const timespec poll{0, std::chrono::nanoseconds(kPoll).count()};
  while (!done) {
    if (sigtimedwait(&signals, nullptr, &poll) > 0) return true;
  }
  return false;
}

void watch(StopRequest& stop, const std::atomic<bool>& done) {
  if (!wait_for_signal(done)) return;
  stop.request();
  const auto deadline = std::chrono::steady_clock::now() + kGrace;
  while (!done && std::chrono::steady_clock::now() < deadline) std::this_thread::sleep_for(kPoll);
  if (done) return;
  const bool is_resumable = stop.is_resumable();
  remove_temporary_paths();
  std::fprintf(stderr, "stream-recon: %s\n", interrupted_message(is_resumable));
  _exit(is_resumable ? kResumableExit : kInterruptedExit);
}

}  // namespace

SignalWatch::SignalWatch(StopRequest& stop) : stop_(stop) {
  const sigset_t signals = watched_signals();
  pthread_sigmask(SIG_BLOCK, &signals, nullptr);
  thread_ = std::thread([this] { watch(stop_, done_); });
}

SignalWatch::~SignalWatch() {
  done_ = true;
  thread_.join();
  const sigset_t signals = watched_signals();
  pthread_sigmask(SIG_UNBLOCK, &signals, nullptr);
}

}  // namespace stream_recon
