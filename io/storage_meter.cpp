#include "io/storage_meter.h"

#include <string>

#include "io/error.h"

namespace stream_recon {

void StorageMeter::charge(std::uint64_t bytes, std::string_view path) {
  std::uint64_t before = used_.load(std::memory_order_relaxed);
  do {
    if (bytes > limit_ - before) {
      throw IoError("cannot add " + std::to_string(bytes) + " bytes to " + std::string(path) +
                    ": " + std::to_string(before) + " of " + std::to_string(limit_) +
                    " scratch bytes are in use; raise --scratch-limit");
    }
  } while (!used_.compare_exchange_weak(before, before + bytes, std::memory_order_relaxed));
  const std::uint64_t after = before + bytes;
  std::uint64_t peak = peak_.load(std::memory_order_relaxed);
  while (peak < after && !peak_.compare_exchange_weak(peak, after, std::memory_order_relaxed)) {
  }
}

void StorageMeter::release(std::uint64_t bytes) {
  used_.fetch_sub(bytes, std::memory_order_relaxed);
}

}  // namespace stream_recon
