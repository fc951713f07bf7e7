// Stopping a run from outside: by a signal, or by the program that called it.
//
// Guarantees: a run that sees the request throws Interrupted at the next block of work, and its
// destructors remove what it put on disk. Thread rule: all calls of StopRequest are thread-safe.
#pragma once

#include <atomic>
#include <exception>
#include <thread>

namespace stream_recon {

/// The run was asked to stop: exit code 130.
class Interrupted : public std::exception {
 public:
  const char* what() const noexcept override { return "interrupted"; }
};

class StopRequest {
 public:
  void request() { requested_.store(true, std::memory_order_relaxed); }
  bool requested() const { return requested_.load(std::memory_order_relaxed); }
  /// \throw Interrupted
  void check() const {
    if (requested()) throw Interrupted();
  }

 private:
  std::atomic<bool> requested_{false};
};

/// While it lives, SIGINT and SIGTERM make the request. A run that does not end within two seconds
/// (it waits for a pipe, or is deep in one long computation) is ended here: all temporary files are
/// removed and the process exits with 130.
/// \pre Made before the process has other threads, which inherit the blocked signals.
class SignalWatch {
 public:
  explicit SignalWatch(StopRequest& stop);
  ~SignalWatch();
  SignalWatch(const SignalWatch&) = delete;
  SignalWatch& operator=(const SignalWatch&) = delete;

 private:
  StopRequest& stop_;
  std::atomic<bool> done_{false};
  std::thread thread_;
};

}  // namespace stream_recon
