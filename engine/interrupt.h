// Stopping a run from outside: by a signal, or by the program that called it.
//
// Guarantees: a run that sees the request throws Interrupted at the next block of work; what it put
// on disk goes, unless a later run can go on from it. Thread rule: all calls of StopRequest are
// thread-safe.
#pragma once

#include <atomic>
#include <exception>
#include <thread>

namespace stream_recon {

/// What a person who has stopped a run should read.
constexpr const char* interrupted_message(bool is_resumable) {
  return is_resumable ? "interrupted: give the same command with --resume to go on"
                      : "interrupted: nothing was kept; start again";
}

/// The run was asked to stop: exit code 75 if it can be resumed, else 130.
class Interrupted : public std::exception {
 public:
  Interrupted() = default;
  explicit Interrupted(bool is_resumable) : is_resumable_(is_resumable) {}

  const char* what() const noexcept override { return interrupted_message(is_resumable_); }
  bool is_resumable() const { return is_resumable_; }

 private:
  bool is_resumable_ = false;
};

class StopRequest {
 public:
  void request() { requested_.store(true, std::memory_order_relaxed); }
  bool requested() const { return requested_.load(std::memory_order_relaxed); }
  /// \throw Interrupted
  void check() const {
    if (requested()) throw Interrupted();
  }

  /// The run says whether a later one could go on from where it is.
  void set_resumable(bool is_resumable) { resumable_ = is_resumable; }
  bool is_resumable() const { return resumable_; }

 private:
  std::atomic<bool> requested_{false};
  std::atomic<bool> resumable_{false};
};

/// While it lives, SIGINT and SIGTERM make the request. A run that does not end within two seconds
/// (it waits for a pipe, or is deep in one long computation) is ended here: all temporary files are
/// removed, but for those that --resume needs, and the process exits with 75 or 130.
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
