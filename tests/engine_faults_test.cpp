// Every system call of a run fails once: the run says so, leaves no output behind, and goes on to
// the same bytes when it is told to.

#include <gtest/gtest.h>

#include <cerrno>
#include <string>
#include <vector>

#include "engine/reconstruct.h"
#include "io/fault_injection.h"
#include "io/folder.h"
#include "tests/io_test_folder.h"

namespace stream_recon {
namespace {

std::string write_cloud(const TestFolder& folder) {
  std::string text;
  for (int i = 0; i < 240; ++i) {
    text += std::to_string(i * 37 % 101) + " " + std::to_string(i * 53 % 97) + " " +
            std::to_string(i * 71 % 89) + "\n";
  }
  put_bytes(folder / "cloud.xyz", text);
  return folder / "cloud.xyz";
}

struct Outputs {
  std::string surface;
  std::string tetrahedra;
  std::string axis{};
};

void PrintTo(const Outputs& outputs, std::ostream* out) {
  *out << outputs.surface << " " << outputs.tetrahedra << " " << outputs.axis;
}

RunOptions options_for(const std::string& cloud, const Outputs& outputs, const TestFolder& folder) {
  RunOptions options;
  options.inputs = {cloud};
  if (outputs.surface.empty()) options.surface = SurfaceKind::kNone;
  if (!outputs.surface.empty()) options.output = folder / outputs.surface;
  if (!outputs.tetrahedra.empty()) options.tetrahedra = folder / outputs.tetrahedra;
  if (!outputs.axis.empty()) options.medial_axis = folder / outputs.axis;
  options.chunk_points = 80;
  options.window_points = 96;
  options.threads = 1;
  return options;
}

/// All bytes in the folder and those in it.
std::string all_bytes(const TestFolder& folder) {
  std::string all;
  for (const std::string& name : folder.names()) {
    if (!is_folder(folder / name)) all += name + file_bytes(folder / name);
    if (!is_folder(folder / name)) continue;
    for (const std::string& chunk : list_folder(folder / name)) {
      all += chunk + file_bytes(folder / name + "/" + chunk);
    }
  }
  return all;
}

/// Runs with the n-th of the given calls failing; false once n is beyond the last call.
bool run_with_fault(const RunOptions& options, const TestFolder& folder, const FaultPlan& plan) {
  bool failed = false;
  const ScopedFault fault(plan);
  try {
    (void)reconstruct(options);
  } catch (const IoError& e) {
    failed = true;
    EXPECT_EQ(std::string(e.what()).find('\n'), std::string::npos);
    const bool is_kept = !folder.names().empty();
    EXPECT_EQ(std::string(e.what()).find("--resume") != std::string::npos, is_kept) << e.what();
  }
  const bool fired = fault.fired();
  EXPECT_EQ(failed, fired) << "call " << plan.fail_at;
  if (!failed) return fired;
  for (const std::string& name : folder.names()) {
    EXPECT_TRUE(name.starts_with("stream-recon.partial-")) << name << ", call " << plan.fail_at;
  }
  return fired;
}

constexpr unsigned bit(IoOperation operation) {
  return static_cast<unsigned>(operation);
}

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr std::uint64_t kStep = 7;  // each run takes ten times as long
#else
constexpr std::uint64_t kStep = 1;
#endif

constexpr std::uint64_t kResumedEvery = 3;

class Faults : public testing::TestWithParam<Outputs> {
 protected:
  void fail_every_call(FaultPlan plan) const {
    const TestFolder input;
    const std::string cloud = write_cloud(input);
    std::string expected;
    for (bool fired = true; fired; plan.fail_at += kStep) {
      const TestFolder folder;
      RunOptions options = options_for(cloud, GetParam(), folder);
      fired = run_with_fault(options, folder, plan);
      if (expected.empty()) expected = undisturbed(cloud);
      const bool goes_on = plan.fail_at % kResumedEvery == 0;
      options.resume = true;
      if (fired && goes_on) (void)reconstruct(options);
      EXPECT_TRUE((fired && !goes_on) || all_bytes(folder) == expected) << "call " << plan.fail_at;
    }
    EXPECT_GT(plan.fail_at, 2U);
  }

  static std::string undisturbed(const std::string& cloud) {
    const TestFolder folder;
    (void)reconstruct(options_for(cloud, GetParam(), folder));
    return all_bytes(folder);
  }
};

TEST_P(Faults, OfAFullDiskEndTheRunCleanlyAndItGoesOn) {
  fail_every_call({bit(IoOperation::kWrite) | bit(IoOperation::kOpen), 0, ENOSPC, true});
}

TEST_P(Faults, OfTheLastStepsLeaveNoOutputWithoutTheOther) {
  fail_every_call({bit(IoOperation::kSync) | bit(IoOperation::kRename), 0, EIO});
}

INSTANTIATE_TEST_SUITE_P(Outputs, Faults,
                         testing::Values(Outputs{"out.pvtp", ""}, Outputs{"out.ply", ""},
                                         Outputs{"out.vtk", ""}, Outputs{"", "t.pvtu"},
                                         Outputs{"out.pvtp", "t.pvtu"},
                                         Outputs{"out.ply", "t.pvtu"}, Outputs{"", "", "m.pvtp"},
                                         Outputs{"out.pvtp", "t.pvtu", "m.pvtp"}));

}  // namespace
}  // namespace stream_recon
