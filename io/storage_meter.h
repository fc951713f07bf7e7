// Counts the bytes that files take on disk, against a limit.
//
// Guarantees: used() never exceeds the limit; peak() is the largest used() ever was.
// Thread rule: all calls are thread-safe. Memory: three words.
#pragma once

#include <atomic>
#include <cstdint>
#include <limits>
#include <string_view>

namespace stream_recon {

class StorageMeter {
 public:
  explicit StorageMeter(std::uint64_t limit_bytes = std::numeric_limits<std::uint64_t>::max())
      : limit_(limit_bytes) {}

  /// Takes `bytes` for the file `path`; nothing is taken when this throws.
  /// \throw IoError the limit would be exceeded
  void charge(std::uint64_t bytes, std::string_view path);
  void release(std::uint64_t bytes);

  std::uint64_t used() const { return used_.load(std::memory_order_relaxed); }
  std::uint64_t peak() const { return peak_.load(std::memory_order_relaxed); }

 private:
  std::uint64_t limit_;
  std::atomic<std::uint64_t> used_{0};
  std::atomic<std::uint64_t> peak_{0};
};

}  // namespace stream_recon
