// Files and folders: every failure is an IoError that says what, where and what to do.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstddef>
#include <span>
#include <string>

#include "io/atomic_output.h"
#include "io/error.h"
#include "io/fault_injection.h"
#include "io/file.h"
#include "io/scratch_directory.h"
#include "tests/io_test_folder.h"

namespace stream_recon {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::ThrowsMessage;

std::span<const std::byte> as_bytes(const std::string& text) {
  return std::as_bytes(std::span(text.data(), text.size()));
}

constexpr auto kChanges =
    static_cast<unsigned>(IoOperation::kOpen) | static_cast<unsigned>(IoOperation::kWrite) |
    static_cast<unsigned>(IoOperation::kSync) | static_cast<unsigned>(IoOperation::kRename) |
    static_cast<unsigned>(IoOperation::kClose);

TEST(File, ReadsBackWhatWasWrittenInSequenceAndAtOffsets) {
  const TestFolder folder;
  File file = File::create(folder / "a");
  file.write(as_bytes("hello "));
  file.write(as_bytes("world"));
  file.write_at(0, as_bytes("J"));
  std::array<std::byte, 5> five{};
  file.read_at(6, five);
  EXPECT_EQ(std::string(reinterpret_cast<const char*>(five.data()), 5), "world");
  EXPECT_EQ(file.size(), 11U);
  file.close();
  std::array<std::byte, 32> all{};
  File reader = File::open(folder / "a");
  ASSERT_EQ(reader.read(all), 11U);
  EXPECT_EQ(std::string(reinterpret_cast<const char*>(all.data()), 11), "Jello world");
  EXPECT_EQ(reader.read(all), 0U);
}

TEST(File, CountsTheBytesOfAllFiles) {
  const TestFolder folder;
  const IoTotals before = io_totals();
  File file = File::create(folder / "a");
  file.write(as_bytes("0123456789"));
  std::array<std::byte, 4> four{};
  file.read_at(3, four);
  EXPECT_EQ(io_totals().bytes_written - before.bytes_written, 10U);
  EXPECT_EQ(io_totals().bytes_read - before.bytes_read, 4U);
}

TEST(File, NamesFileReasonAndRemedy) {
  const TestFolder folder;
  EXPECT_THAT(
      [&] { File::open(folder / "none"); },
      ThrowsMessage<IoError>(AllOf(HasSubstr("cannot open " + folder.path() + "/none"),
                                   HasSubstr("No such file"), HasSubstr("check the path"))));
  File::create(folder / "a");
  EXPECT_THAT([&] { File::create(folder / "a"); }, ThrowsMessage<IoError>(HasSubstr("exists")));
}

TEST(File, NamesTheByteWhereADiskFillsUp) {
  const TestFolder folder;
  File file = File::create(folder / "a");
  file.write(as_bytes("12345678"));
  const ScopedFault fault({static_cast<unsigned>(IoOperation::kWrite), 0, ENOSPC});
  EXPECT_THAT([&] { file.write(as_bytes("abcd")); },
              ThrowsMessage<IoError>(AllOf(HasSubstr("write 4 bytes at byte 8 of " + file.path()),
                                           HasSubstr("No space left"), HasSubstr("--scratch"),
                                           Not(HasSubstr("\n")))));
}

TEST(File, NamesTheByteWhereAFileEndsTooSoon) {
  const TestFolder folder;
  put_bytes(folder / "a", "123");
  const File file = File::open(folder / "a");
  std::array<std::byte, 4> four{};
  EXPECT_THAT([&] { file.read_at(1, four); }, ThrowsMessage<IoError>(HasSubstr("ends at byte 3")));
}

TEST(File, ReadErrorsAreErrorsNotTheEnd) {
  const TestFolder folder;
  put_bytes(folder / "a", "123");
  File file = File::open(folder / "a");
  std::array<std::byte, 4> four{};
  const ScopedFault fault({static_cast<unsigned>(IoOperation::kRead), 0, EIO});
  EXPECT_THAT([&] { file.read(four); }, ThrowsMessage<IoError>(HasSubstr("Input/output error")));
}

TEST(ScratchDirectory, CountsBytesKeepsThePeakAndForgetsRemovedFiles) {
  const TestFolder folder;
  ScratchDirectory scratch({folder.path()});
  File a = scratch.create("a");
  a.write(as_bytes("1234"));
  a.write_at(2, as_bytes("5678"));
  EXPECT_EQ(scratch.used_bytes(), 6U);
  a.close();
  scratch.remove("a");
  EXPECT_EQ(scratch.used_bytes(), 0U);
  scratch.create("b").write(as_bytes("1"));
  EXPECT_EQ(scratch.used_bytes(), 1U);
  EXPECT_EQ(scratch.peak_bytes(), 6U);
}

TEST(ScratchDirectory, RefusesToGrowOverTheLimitAndSaysHowToRaiseIt) {
  const TestFolder folder;
  ScratchDirectory scratch({folder.path(), 8});
  File a = scratch.create("a");
  File b = scratch.create("b");
  a.write(as_bytes("12345"));
  EXPECT_THAT([&] { b.write(as_bytes("1234")); },
              ThrowsMessage<IoError>(AllOf(HasSubstr("5 of 8"), HasSubstr("--scratch-limit"))));
  b.write(as_bytes("123"));
  EXPECT_EQ(scratch.used_bytes(), 8U);
}

TEST(ScratchDirectory, LeavesNothingBehindWhenAnErrorUnwinds) {
  const TestFolder folder;
  try {
    ScratchDirectory scratch({folder.path()});
    scratch.create("a").write(as_bytes("1"));
    scratch.create("b");
    throw IoError("later");
  } catch (const IoError&) {
    EXPECT_THAT(folder.names(), IsEmpty());
  }
}

TEST(ScratchDirectory, LeavesNothingBehindWhenASignalEndsTheRun) {
  const TestFolder folder;
  ScratchDirectory scratch({folder.path()});
  // More names than one getdents buffer holds.
  for (int i = 0; i < 500; ++i) scratch.create("spool-of-stage-" + std::to_string(i));
  AtomicOutput output(folder / "mesh.ply");
  output.file().write(as_bytes("ply"));
  remove_temporary_paths();
  EXPECT_THAT(folder.names(), IsEmpty());
}

TEST(ScratchDirectory, IsGoneWhenARealSignalEndedTheProcess) {
  const TestFolder folder;
  const auto run_and_interrupt = [&] {
    struct sigaction action {};
    action.sa_handler = [](int) {
      remove_temporary_paths();
      ::_exit(130);
    };
    ::sigaction(SIGINT, &action, nullptr);
    ScratchDirectory scratch({folder.path()});
    File file = scratch.create("spool");
    for (;;) {
      file.write(as_bytes("0123456789"));
      if (file.position() > 100000) ::raise(SIGINT);
    }
  };
  EXPECT_EXIT(run_and_interrupt(), testing::ExitedWithCode(130), "");
  EXPECT_THAT(folder.names(), IsEmpty());
}

TEST(ScratchDirectory, TakesPlainNamesOnly) {
  const TestFolder folder;
  ScratchDirectory scratch({folder.path()});
  EXPECT_THROW(scratch.create("../a"), std::invalid_argument);
  EXPECT_THROW(scratch.create(""), std::invalid_argument);
}

TEST(AtomicOutput, ShowsTheOldFileUntilCommitAndTheNewOneAfter) {
  const TestFolder folder;
  put_bytes(folder / "a", "old");
  AtomicOutput output(folder / "a");
  output.file().write(as_bytes("new"));
  EXPECT_EQ(file_bytes(folder / "a"), "old");
  output.commit();
  EXPECT_EQ(file_bytes(folder / "a"), "new");
  EXPECT_THAT(folder.names(), ElementsAre("a"));
}

TEST(AtomicOutput, RefusesAFolderAtTheStart) {
  const TestFolder folder;
  make_folder(folder / "a");
  EXPECT_THROW(AtomicOutput(folder / "a"), IoError);
  EXPECT_THAT(folder.names(), ElementsAre("a"));
}

TEST(AtomicOutput, EveryFailingCallLeavesTheOldFileOrNone) {
  bool fired = true;
  for (std::uint64_t n = 0; fired; ++n) {
    SCOPED_TRACE("failing call " + std::to_string(n));
    const TestFolder folder;
    put_bytes(folder / "a", "old");
    bool failed = false;
    {
      const ScopedFault fault({kChanges, n, ENOSPC});
      try {
        AtomicOutput output(folder / "a");
        output.file().write(as_bytes("new"));
        output.commit();
      } catch (const IoError&) {
        failed = true;
      }
      fired = fault.fired();
    }
    EXPECT_EQ(failed, fired);
    if (!failed) continue;
    if (!folder.names().empty()) {
      EXPECT_THAT(folder.names(), ElementsAre("a"));
      EXPECT_EQ(file_bytes(folder / "a"), "old");
    }
  }
}

}  // namespace
}  // namespace stream_recon
