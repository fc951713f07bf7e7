// Makes chosen system calls fail, so that tests can walk every failure an operating system can
// produce (after the fault injecting environment of LevelDB, Ghemawat and Dean 2011).
//
// Guarantees: without a plan the library pays one atomic load a call. A failing or killing write
// stores half of its bytes first, as a disk that fills up does. Thread rule: set and clear while no
// other thread is in a call of this layer; counting itself is thread-safe.
#pragma once

#include <cstdint>

namespace stream_recon {

enum class IoOperation : unsigned {
  kOpen = 1,
  kRead = 2,
  kWrite = 4,
  kSync = 8,
  kRename = 16,
  kMakeDirectory = 32,
  kClose = 64,
};

struct FaultPlan {
  /// Bits of IoOperation that count.
  unsigned operations = 0;
  /// The first counted call that fails, from 0.
  std::uint64_t fail_at = 0;
  /// What the call reports, for example ENOSPC.
  int error = 0;
  /// Whether all counted calls after it fail too (a disk that stays full).
  bool stays = false;
  /// The call kills the process instead, as power cuts and impatient people do.
  bool kills = false;
};

/// Holds a plan in force while it lives; one at a time.
class ScopedFault {
 public:
  explicit ScopedFault(const FaultPlan& plan);
  ~ScopedFault();
  ScopedFault(const ScopedFault&) = delete;
  ScopedFault& operator=(const ScopedFault&) = delete;

  /// Whether the plan's call was reached, that is, whether anything failed.
  bool fired() const;
};

namespace detail {
/// The errno that this call must report, 0 for none. Kills the process if that is the plan, unless
/// the call is a write, which calls die_if_planned() when half of it is done.
int injected_error(IoOperation operation);
void die_if_planned();
}  // namespace detail

}  // namespace stream_recon
