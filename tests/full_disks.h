// Runs that meet a full disk, earlier or later, and go on with `resume`.
#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "engine/reconstruct.h"
#include "io/fault_injection.h"
#include "tests/io_test_folder.h"

namespace stream_recon {

/// Expects the bytes of a run without faults, and no file more, after the disk was full from the
/// third write on, then from `step` writes later, and so on, until a run ends before its disk does.
/// \param bytes of the outputs \return how many runs failed
inline int expect_same_after_full_disks(RunOptions options, const TestFolder& folder,
                                        std::uint64_t step,
                                        const std::function<std::string()>& bytes) {
  constexpr int kNoSpace = 28;
  (void)reconstruct(options);
  const std::string expected = bytes();
  const std::vector<std::string> names = folder.names();
  int failures = 0;
  for (std::uint64_t call = 3;; call += step) {
    options.resume = false;
    bool has_failed = false;
    {
      const ScopedFault fault({.operations = static_cast<unsigned>(IoOperation::kWrite),
                               .fail_at = call,
                               .error = kNoSpace,
                               .stays = true});
      try {
        (void)reconstruct(options);
      } catch (const IoError&) {
        has_failed = true;
      }
    }
    if (!has_failed) return failures;
    ++failures;
    options.resume = true;
    (void)reconstruct(options);
    EXPECT_TRUE(bytes() == expected) << "write " << call;
    EXPECT_EQ(folder.names(), names) << "write " << call;
  }
}

}  // namespace stream_recon
