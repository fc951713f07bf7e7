#include "engine/process_memory.h"

#include <malloc.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <string>

namespace stream_recon {
namespace {

constexpr int kMapThreshold = 256 * 1024;
constexpr int kTrimThreshold = 1024 * 1024;
constexpr int kMostArenas = 2;

/// The value of `key` (for example "VmHWM:") in /proc/self/status, bytes; 0 if it is not there.
std::uint64_t status_bytes(const std::string& key) {
  std::ifstream status("/proc/self/status");
  std::string word;
  while (status >> word) {
    std::uint64_t kibibytes = 0;
    if (word == key && status >> kibibytes) return kibibytes * 1024;
  }
  return 0;
}

/// The memory limit of the control group; nothing said means none.
std::uint64_t control_group_limit() {
  std::ifstream limit("/sys/fs/cgroup/memory.max");
  std::uint64_t bytes = 0;
  return limit >> bytes ? bytes : ~std::uint64_t{0};
}

}  // namespace

// Not getrusage first: its maximum counts the parent's memory between fork and exec.
std::uint64_t peak_resident_bytes() {
  if (const std::uint64_t bytes = status_bytes("VmHWM:")) return bytes;
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<std::uint64_t>(usage.ru_maxrss) * 1024;
}

std::uint64_t resident_bytes() {
  return status_bytes("VmRSS:");
}

std::uint64_t physical_memory_bytes() {
  const std::uint64_t machine = static_cast<std::uint64_t>(sysconf(_SC_PHYS_PAGES)) *
                                static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE));
  return std::min(machine, control_group_limit());
}

// A fixed threshold switches off glibc's habit of raising it, after which freed large blocks would
// stay in the heap.
void make_allocator_return_memory() {
  mallopt(M_MMAP_THRESHOLD, kMapThreshold);
  mallopt(M_TRIM_THRESHOLD, kTrimThreshold);
  mallopt(M_ARENA_MAX, kMostArenas);
}

void trim_allocator() {
  malloc_trim(0);
}

}  // namespace stream_recon
