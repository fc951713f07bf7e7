#include "io/fault_injection.h"

#include <atomic>
#include <cassert>
#include <csignal>

namespace stream_recon {
namespace {

FaultPlan active_plan;
std::atomic<bool> is_active{false};
std::atomic<std::uint64_t> calls{0};

}  // namespace

ScopedFault::ScopedFault(const FaultPlan& plan) {
  assert(!is_active.load());
  active_plan = plan;
  calls = 0;
  is_active.store(true, std::memory_order_release);
}

ScopedFault::~ScopedFault() {
  is_active.store(false, std::memory_order_release);
}

bool ScopedFault::fired() const {
  return calls.load() > active_plan.fail_at;
}

int detail::injected_error(IoOperation operation) {
  if (!is_active.load(std::memory_order_acquire)) return 0;
  if ((active_plan.operations & static_cast<unsigned>(operation)) == 0) return 0;
  const std::uint64_t call = calls.fetch_add(1, std::memory_order_relaxed);
  const bool fails = active_plan.stays ? call >= active_plan.fail_at : call == active_plan.fail_at;
  if (fails && operation != IoOperation::kWrite) die_if_planned();
  return fails ? active_plan.error : 0;
}

void detail::die_if_planned() {
  if (active_plan.kills) std::raise(SIGKILL);
}

}  // namespace stream_recon
