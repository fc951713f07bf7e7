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

struct Outputs {
  std::string surface;
  std::string tetrahedra;
};

void PrintTo(const Outputs& outputs, std::ostream* out) {
  *out << outputs.surface << " " << outputs.tetrahedra;
}

/// Runs with the n-th of the given calls failing; false once n is beyond the last call.
bool run_with_fault(const std::string& cloud, const Outputs& outputs, const FaultPlan& plan) {
  const TestFolder folder;
  RunOptions options;
  options.inputs = {cloud};
  if (outputs.surface.empty()) options.surface = SurfaceKind::kNone;
  if (!outputs.surface.empty()) options.output = folder / outputs.surface;
  if (!outputs.tetrahedra.empty()) options.tetrahedra = folder / outputs.tetrahedra;
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

constexpr unsigned bit(IoOperation operation) {
  return static_cast<unsigned>(operation);
}

class Faults : public testing::TestWithParam<Outputs> {
 protected:
  void fail_every_call(FaultPlan plan) const {
    const TestFolder folder;
    const std::string cloud = write_cloud(folder);
    while (run_with_fault(cloud, GetParam(), plan)) ++plan.fail_at;
    EXPECT_GT(plan.fail_at, 1U);
  }
};

TEST_P(Faults, OfAFullDiskEndTheRunCleanly) {
  fail_every_call({bit(IoOperation::kWrite) | bit(IoOperation::kOpen), 0, ENOSPC, true});
}

TEST_P(Faults, OfTheLastStepsLeaveNoOutputWithoutTheOther) {
  fail_every_call({bit(IoOperation::kSync) | bit(IoOperation::kRename), 0, EIO});
}

INSTANTIATE_TEST_SUITE_P(Outputs, Faults,
                         testing::Values(Outputs{"out.pvtp", ""}, Outputs{"out.ply", ""},
                                         Outputs{"out.vtk", ""}, Outputs{"", "t.pvtu"},
                                         Outputs{"out.pvtp", "t.pvtu"},
                                         Outputs{"out.ply", "t.pvtu"}));

}  // namespace
}  // namespace stream_recon
