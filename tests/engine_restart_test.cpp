// A run that is killed goes on to the same bytes: killed at every write, rename, opening of a file
// and new folder, and at random moments; with other windows and threads each time.

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <csignal>
#include <fstream>
#include <random>
#include <string>
#include <thread>
#include <vector>

#include "engine/reconstruct.h"
#include "engine/restart/manifest.h"
#include "engine/restart/run_identity.h"
#include "engine/restart/run_journal.h"
#include "io/fault_injection.h"
#include "io/folder.h"
#include "tests/io_test_folder.h"
#include "tests/point_families.h"

namespace stream_recon {
namespace {

using testing::HasSubstr;

constexpr std::uint64_t kSeed = 77;
constexpr unsigned kWrite = static_cast<unsigned>(IoOperation::kWrite);
constexpr unsigned kNames =
    static_cast<unsigned>(IoOperation::kRename) | static_cast<unsigned>(IoOperation::kOpen) |
    static_cast<unsigned>(IoOperation::kMakeDirectory) | static_cast<unsigned>(IoOperation::kSync);

struct DriverRun {
  unsigned operations = 0;
  long call = -1;
  int window_points = 160;
  int threads = 1;
  bool resume = false;
  std::chrono::microseconds kill_after{0};  ///< 0: not from outside
};

/// A folder with a cloud, and the bytes that a run makes of it when nobody disturbs it.
class Restart : public testing::Test {
 protected:
  void SetUp() override {
    std::mt19937_64 random(kSeed);
    std::string bytes;
    for (int i = 0; i < 1500; ++i) {
      const Point3 p = families::random_point(random);
      bytes.append(reinterpret_cast<const char*>(&p), sizeof p);
    }
    put_bytes(folder_ / "cloud.f64", bytes);
    ASSERT_EQ(run({}), 0);
    expected_ = result();
    remove_result();
    ASSERT_EQ(folder_.names(), std::vector<std::string>{"cloud.f64"});
  }

  /// The exit code, or minus the signal that ended it.
  int run(const DriverRun& options) const {
    std::vector<std::string> words{STREAM_RECON_RESTART_DRIVER,
                                   std::to_string(options.operations),
                                   std::to_string(options.call),
                                   folder_ / "cloud.f64",
                                   folder_ / "out",
                                   std::to_string(options.window_points),
                                   std::to_string(options.threads)};
    if (options.resume) words.emplace_back("resume");
    std::vector<char*> arguments;
    for (std::string& word : words) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    pid_t child = 0;
    EXPECT_EQ(posix_spawn(&child, words[0].c_str(), nullptr, nullptr, arguments.data(), environ),
              0);
    if (options.kill_after.count() > 0) {
      std::this_thread::sleep_for(options.kill_after);
      kill(child, SIGKILL);
    }
    int status = 0;
    EXPECT_EQ(waitpid(child, &status, 0), child);
    return WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
  }

  std::string result() const {
    std::string all;
    for (const std::string name : {"out.pvtp", "out-t.pvtu", "out-u.ply", "out-m.pvtp"})
      all += file_bytes(folder_ / name);
    for (const std::string name : {"out", "out-t", "out-m"}) {
      for (const std::string& chunk : list_folder(folder_ / name)) {
        all += chunk + file_bytes(folder_ / name + "/" + chunk);
      }
    }
    return all;
  }

  void remove_result() const {
    for (const char* name : {"out.pvtp", "out-t.pvtu", "out-u.ply", "out-m.pvtp"})
      remove_file((folder_ / name).c_str());
    for (const char* name : {"out", "out-t", "out-m"}) remove_folder((folder_ / name).c_str());
  }

  /// An index may stand there only with a complete result.
  void expect_no_half_result() const {
    for (const std::string name : {"out", "out-t", "out-m"}) {
      const std::string index = folder_ / name + (name == "out-t" ? ".pvtu" : ".pvtp");
      EXPECT_TRUE(!path_exists(index) || path_exists(folder_ / name)) << name;
    }
  }

  void expect_resumed(const std::string& after) const {
    EXPECT_EQ(run({.window_points = 240, .threads = 2, .resume = true}), 0) << after;
    EXPECT_TRUE(result() == expected_) << after;
    remove_result();
    EXPECT_EQ(folder_.names(), std::vector<std::string>{"cloud.f64"}) << after;
  }

  std::string scratch() const {
    for (const std::string& name : folder_.names()) {
      if (name.starts_with("stream-recon.partial-")) return folder_ / name;
    }
    return "";
  }

  /// Kills a run at its first call of a kind after which the manifest has finished windows.
  void leave_windows_behind() const {
    for (long call = 40;; ++call) {
      ASSERT_EQ(run({.operations = kWrite, .call = call}), -SIGKILL);
      if (windows_done() > 300) return;
      for (const std::string& name : folder_.names()) {
        if (name == "cloud.f64") continue;
        remove_folder((folder_ / name).c_str());
        remove_file((folder_ / name).c_str());
      }
    }
  }

  std::uint64_t windows_done() const {
    if (scratch().empty()) return 0;
    const auto manifest = manifest_from_text(file_bytes(scratch() + "/" + kManifest));
    return manifest ? manifest->windows.done_points() : 0;
  }

  TestFolder folder_;
  std::string expected_;
};

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr long kStep = 23;  // each run takes a hundred times as long
constexpr int kRandomKills = 6;
#else
constexpr long kStep = 3;
constexpr int kRandomKills = 40;
#endif

TEST_F(Restart, AfterAKillAtAnyCallThatChangesTheDiskGivesTheSameBytes) {
  int kills = 0;
  for (const unsigned operations : {kWrite, kNames}) {
    for (long call = 0;; call += kStep) {
      const int code = run({.operations = operations, .call = call});
      if (code == 0) {
        EXPECT_TRUE(result() == expected_);
        remove_result();
        break;
      }
      ASSERT_EQ(code, -SIGKILL) << call;
      ++kills;
      expect_no_half_result();
      expect_resumed("operations " + std::to_string(operations) + ", call " + std::to_string(call));
    }
  }
  EXPECT_GT(kills, kStep == 3 ? 50 : 5);
}

TEST_F(Restart, AfterKillsAtRandomMomentsGivesTheSameBytes) {
  std::mt19937_64 random(kSeed);
  SCOPED_TRACE("seed " + std::to_string(kSeed));
  for (int kills = 0; kills < kRandomKills; ++kills) {
    const DriverRun options{.window_points = 64 + static_cast<int>(random() % 500),
                            .threads = 1 + static_cast<int>(random() % 3),
                            .resume = true,
                            .kill_after = std::chrono::microseconds(1000 + random() % 80000)};
    const int code = run(options);
    ASSERT_TRUE(code == 0 || code == -SIGKILL) << code;
    expect_no_half_result();
  }
  expect_resumed("random kills");
}

TEST_F(Restart, GoesOnFromTheLastFinishedWindow) {
  leave_windows_behind();
  const std::uint64_t done = windows_done();
  // A run that is killed at once has not lost what was done before.
  ASSERT_EQ(run({.operations = kWrite, .call = 2, .resume = true}), -SIGKILL);
  EXPECT_EQ(windows_done(), done);
  expect_resumed("two kills");
}

TEST_F(Restart, WithDamagedFilesDoesThemAgain) {
  for (const std::string damaged : {"points", "window_0", kManifest}) {
    for (const bool cut : {false, true}) {
      leave_windows_behind();
      const std::string path = scratch() + "/" + damaged;
      std::string bytes = file_bytes(path);
      ASSERT_GT(bytes.size(), 100U) << damaged;
      if (cut) bytes.resize(bytes.size() / 2);
      if (!cut) bytes[bytes.size() / 2] ^= 1;
      std::ofstream(path, std::ios::binary | std::ios::trunc) << bytes;
      EXPECT_EQ(run({.window_points = 240, .resume = true}), 0) << damaged;
      EXPECT_TRUE(result() == expected_) << damaged;
      remove_result();
      if (damaged == kManifest) remove_folder(scratch().c_str());  // left alone: whose is it?
      EXPECT_EQ(scratch(), "") << damaged;
    }
  }
}

TEST_F(Restart, NoticesAWindowThatIsLost) {
  leave_windows_behind();
  remove_file((scratch() + "/window_0").c_str());
  expect_resumed("a lost window");
}

TEST_F(Restart, WithoutTheOptionBeginsAnewAndTidiesUp) {
  leave_windows_behind();
  ASSERT_EQ(run({.window_points = 0}), 0);
  EXPECT_TRUE(result() == expected_);
  remove_result();
  EXPECT_EQ(folder_.names(), std::vector<std::string>{"cloud.f64"});
}

RunOptions options_in(const TestFolder& folder) {
  RunOptions options;
  options.inputs = {folder / "cloud.f64"};
  options.output = folder / "out.pvtp";
  options.tetrahedra = folder / "out-t.pvtu";
  options.unused = folder / "out-u.ply";
  options.medial_axis = folder / "out-m.pvtp";
  options.chunk_points = 500;
  options.resume = true;
  return options;
}

template <class Error>
std::string refusal(const RunOptions& options) {
  try {
    (void)reconstruct(options);
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

TEST_F(Restart, WithOtherOptionsOrInputIsRefusedAndLeavesWhatWasDone) {
  leave_windows_behind();
  const std::uint64_t done = windows_done();
  RunOptions options = options_in(folder_);
  options.chunk_points = 400;
  EXPECT_THAT(refusal<std::invalid_argument>(options), HasSubstr("--chunk-points: 500 then"));
  options = options_in(folder_);
  options.open_ratio = 4;
  EXPECT_THAT(refusal<std::invalid_argument>(options), HasSubstr("--open: nothing then, 4 now"));
  options = options_in(folder_);
  options.manifold = true;
  EXPECT_THAT(refusal<std::invalid_argument>(options), HasSubstr("cannot resume: --manifold"));
  options = options_in(folder_);
  options.medial_axis_side = PoleSide::kBoth;
  EXPECT_THAT(refusal<std::invalid_argument>(options), HasSubstr("--medial-axis-side: inner then"));
  options = options_in(folder_);
  options.grid_spacing = {1, 1, 2};
  EXPECT_THAT(refusal<std::invalid_argument>(options), HasSubstr("--spacing: nothing then"));
  EXPECT_EQ(windows_done(), done);
  std::string cloud = file_bytes(folder_ / "cloud.f64");
  cloud[8] ^= 1;
  std::ofstream(folder_ / "cloud.f64", std::ios::binary | std::ios::trunc) << cloud;
  EXPECT_THAT(refusal<InputError>(options_in(folder_)), HasSubstr("cannot resume: input 1"));
  EXPECT_EQ(windows_done(), done);
}

TEST_F(Restart, KnowsEachOptionThatASolidDependsOn) {
  RunOptions options = options_in(folder_);
  options.surface = SurfaceKind::kSolid;
  const RunIdentity closed = identity_of(options);
  options.open_ratio = 5;
  const RunIdentity open = identity_of(options);
  options.grid_spacing = {1, 1, 2.5};
  EXPECT_EQ(difference(closed, open), "--open: nothing then, 5 now");
  EXPECT_EQ(difference(open, identity_of(options)), "--spacing: nothing then, 1,1,2.5 now");
  const RunIdentity balls = identity_of(options);
  options.medial_axis_faces = true;
  EXPECT_EQ(difference(balls, identity_of(options)),
            "--medial-axis-faces: nothing then, given now");
  options.unused.clear();
  EXPECT_FALSE(have_same_outputs(open, identity_of(options)));
  options = options_in(folder_);
  options.medial_axis.clear();
  EXPECT_FALSE(have_same_outputs(open, identity_of(options)));
}

TEST_F(Restart, OfAnotherOutputLeavesTheDeadRunAlone) {
  leave_windows_behind();
  const std::uint64_t done = windows_done();
  RunOptions options = options_in(folder_);
  options.output = folder_ / "other.pvtp";
  (void)reconstruct(options);
  EXPECT_EQ(windows_done(), done);
}

TEST_F(Restart, OfARunThatIsAliveIsRefused) {
  leave_windows_behind();
  const auto alive = FolderLock::try_take(scratch());
  ASSERT_TRUE(alive.has_value());
  for (const bool resume : {false, true}) {
    RunOptions options = options_in(folder_);
    options.resume = resume;
    EXPECT_THAT(refusal<IoError>(options), HasSubstr("is under way in"));
  }
}

RunOptions options_without_files(const TestFolder& folder) {
  RunOptions options = options_in(folder);
  options.resume = false;
  options.surface = SurfaceKind::kNone;
  options.tetrahedra.clear();
  options.unused.clear();
  options.medial_axis.clear();
  options.scratch = folder.path();
  return options;
}

/// Fails as soon as something would be kept.
void leave_dead_run(const RunOptions& options) {
  for (std::uint64_t call = 0; scratch_folders(options.scratch).empty(); ++call) {
    const ScopedFault fault({.operations = kWrite, .fail_at = call, .error = EIO, .stays = true});
    ASSERT_THROW((void)reconstruct(options), IoError);
  }
}

TEST_F(Restart, OfARunWithoutFilesMindsNoOtherThatIsAlive) {
  RunOptions options = options_without_files(folder_);
  leave_dead_run(options);
  const auto alive = FolderLock::try_take(scratch());
  ASSERT_TRUE(alive.has_value());
  std::vector<std::string> notices;
  options.on_notice = [&](const std::string& notice) { notices.push_back(notice); };
  (void)reconstruct(options);
  EXPECT_THAT(notices, testing::IsEmpty());
}

TEST_F(Restart, OfADeadRunWithoutFilesIsOfferedAndNotRemoved) {
  RunOptions options = options_without_files(folder_);
  leave_dead_run(options);
  const std::string dead = scratch();
  std::vector<std::string> notices;
  options.on_notice = [&](const std::string& notice) { notices.push_back(notice); };
  (void)reconstruct(options);
  EXPECT_THAT(notices, testing::ElementsAre(HasSubstr("go on with --resume, or remove it")));
  EXPECT_TRUE(path_exists(dead));
  options.resume = true;
  (void)reconstruct(options);
  EXPECT_EQ(scratch(), "");
}

TEST_F(Restart, WithNothingToResumeBeginsAndSaysSo) {
  RunOptions options = options_in(folder_);
  std::vector<std::string> notices;
  options.on_notice = [&](const std::string& notice) { notices.push_back(notice); };
  (void)reconstruct(options);
  EXPECT_THAT(notices, testing::ElementsAre(HasSubstr("nothing to resume in")));
  EXPECT_TRUE(result() == expected_);
}

TEST(Manifest, ComesBackAsItWas) {
  Manifest manifest;
  manifest.identity = {{"output", "/a \"b\"\n/c.pvtp"}, {"input 1", "-"}};
  manifest.cloud = CloudSummary{};
  manifest.cloud->points = 12345678901234ULL;
  manifest.cloud->box.extend({0.1, -1e-310, 3e300});
  manifest.cloud->range.extend(Point3{0.1, -1e-310, 3e30});
  manifest.order = OrderResult{7, 5};
  for (const OwnedRange range : {OwnedRange{0, 16}, {48, 16}, {16, 16}, {32, 16}, {96, 3}}) {
    manifest.windows.add_range(range);
  }
  manifest.windows.totals.tetrahedra.digest = SimplexDigest(~std::uint64_t{0} - 5);
  const auto back = manifest_from_text(to_text(manifest));
  ASSERT_TRUE(back.has_value());
  EXPECT_EQ(to_text(*back), to_text(manifest));
  EXPECT_EQ(back->cloud->box.low, manifest.cloud->box.low);
  EXPECT_EQ(back->windows.done.size(), 2U);
  EXPECT_EQ(back->windows.done_points(), 67U);
  EXPECT_EQ(back->windows.open_ranges(200).size(), 2U);
}

TEST(Manifest, NoticesEveryChangedByteAndEveryTruncation) {
  Manifest manifest;
  manifest.identity = {{"output", "out"}};
  const std::string text = to_text(manifest);
  for (std::size_t i = 0; i < text.size(); ++i) {
    std::string changed = text;
    changed[i] ^= 1;
    EXPECT_FALSE(manifest_from_text(changed).has_value()) << i;
    EXPECT_FALSE(manifest_from_text(text.substr(0, i)).has_value()) << i;
  }
}

}  // namespace
}  // namespace stream_recon
