// Every system call of a run fails once: the run says so and leaves nothing behind.

#include <gtest/gtest.h>

#include <cerrno>
#include <string>
#include <vector>

#include "engine/reconstruct.h"
#include "io/fault_injection.h"
#include "tests/io_test_folder.h"

namespace stream_recon {
namespace {

std::string write_cloud(const TestFolder& folder) {
  std::string text;
  for (int i = 0; i < 400; ++i) {
    text += std::to_string(i * 37 % 101) + " " + std::to_string(i * 53 % 97) + " " +
            std::to_string(i * 71 % 89) + "\n";
  }
  put_bytes(folder / "cloud.xyz", text);
  return folder / "cloud.xyz";
}

/// Runs with the n-th of the given calls failing; false once n is beyond the last call.
bool run_with_fault(const std::string& cloud, const std::string& name, const FaultPlan& plan) {
  const TestFolder folder;
  RunOptions options;
  options.inputs = {cloud};
  options.output = folder / name;
  options.chunk_points = 50;
  options.threads = 1;
  bool failed = false;
  const ScopedFault fault(plan);
  try {
    (void)reconstruct(options);
  } catch (const IoError& e) {
    failed = true;
    EXPECT_EQ(std::string(e.what()).find('\n'), std::string::npos);
  }
  const bool fired = fault.fired();
  EXPECT_EQ(failed, fired) << "call " << plan.fail_at;
  EXPECT_EQ(folder.names().empty(), failed) << "call " << plan.fail_at;
  return fired;
}

class Faults : public testing::TestWithParam<const char*> {};

TEST_P(Faults, OfAFullDiskEndTheRunCleanly) {
  const TestFolder folder;
  const std::string cloud = write_cloud(folder);
  std::uint64_t calls = 0;
  const auto operations =
      static_cast<unsigned>(IoOperation::kWrite) | static_cast<unsigned>(IoOperation::kOpen);
  while (run_with_fault(cloud, GetParam(), {operations, calls, ENOSPC, true})) ++calls;
  EXPECT_GT(calls, 10U);
}

INSTANTIATE_TEST_SUITE_P(Outputs, Faults, testing::Values("out.pvtp", "out.ply", "out.vtk"),
                         [](const auto& test) { return std::string(test.param).substr(4); });

}  // namespace
}  // namespace stream_recon
