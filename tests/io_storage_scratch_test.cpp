// The scratch directory's names: its own, those of the dead, and who may have them.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <unistd.h>

#include <csignal>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <utility>

#include "io/error.h"
#include "io/folder.h"
#include "io/scratch_directory.h"
#include "tests/io_test_folder.h"

namespace stream_recon {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

std::span<const std::byte> as_bytes(std::string_view text) {
  return std::as_bytes(std::span(text));
}

TEST(FolderLock, IsHeldByOneAtATimeAndGoesWithItsHolder) {
  const TestFolder folder;
  auto lock = FolderLock::try_take(folder.path());
  ASSERT_TRUE(lock.has_value());
  EXPECT_FALSE(FolderLock::try_take(folder.path()).has_value());
  lock.reset();
  EXPECT_TRUE(FolderLock::try_take(folder.path()).has_value());
  EXPECT_FALSE(FolderLock::try_take(folder / "missing").has_value());
}

TEST(FolderLock, IsLetGoWhenItsProcessIsKilled) {
  const TestFolder folder;
  EXPECT_EXIT(
      {
        const auto lock = FolderLock::try_take(folder.path());
        if (lock) ::raise(SIGKILL);
        ::_exit(1);
      },
      testing::KilledBySignal(SIGKILL), "");
  EXPECT_TRUE(FolderLock::try_take(folder.path()).has_value());
}

TEST(KeptScratch, StaysIsAdoptedUnderAnotherNameAndGoesWhenDiscarded) {
  const TestFolder folder;
  std::string first;
  {
    ScratchDirectory scratch({folder.path()});
    scratch.create("a").write(as_bytes("12345"));
    scratch.keep();
    first = scratch.path();
    remove_temporary_paths();
    EXPECT_FALSE(FolderLock::try_take(first).has_value());
  }
  ASSERT_THAT(scratch_folders(folder.path()), ElementsAre(first));
  auto lock = FolderLock::try_take(first);
  ASSERT_TRUE(lock.has_value());
  {
    ScratchDirectory adopted({first, std::move(*lock)}, {folder.path()});
    EXPECT_NE(adopted.path(), first);
    EXPECT_FALSE(path_exists(first));
    EXPECT_THAT(adopted.names(), ElementsAre("a"));
    EXPECT_EQ(adopted.used_bytes(), 5U);
    EXPECT_FALSE(FolderLock::try_take(adopted.path()).has_value());
    adopted.discard();
  }
  EXPECT_THAT(folder.names(), IsEmpty());
}

TEST(KeptScratch, CountsAgainstTheLimitOfTheRunThatAdoptsIt) {
  const TestFolder folder;
  std::string path;
  {
    ScratchDirectory scratch({folder.path()});
    scratch.create("a").write(as_bytes("12345"));
    scratch.keep();
    path = scratch.path();
  }
  EXPECT_THROW(ScratchDirectory({path, *FolderLock::try_take(path)}, {folder.path(), 4}), IoError);
}

TEST(ScratchFiles, AreReplacedInOneStepAndTheirBytesCountedOnce) {
  const TestFolder folder;
  ScratchDirectory scratch({folder.path()});
  scratch.replace("m", "first");
  scratch.replace("m", "and second");
  EXPECT_EQ(file_bytes(scratch.path() + "/m"), "and second");
  EXPECT_EQ(scratch.used_bytes(), 10U);
  scratch.rename("m", "n");
  EXPECT_TRUE(scratch.has("n"));
  EXPECT_THAT(scratch.names(), ElementsAre("n"));
}

TEST(TemporaryNames, AreToldFromOthersAndThoseOfOneProcessAreRemovedTogether) {
  const TestFolder folder;
  const std::string mine = temporary_name_beside(folder / "out.ply");
  put_bytes(mine, "half");
  const std::string chunks = temporary_name_beside(folder / "out.ply");
  make_folder(chunks);
  put_bytes(chunks + "/chunk", "half");
  put_bytes(folder / "out.ply", "whole");
  put_bytes(folder / "out.ply.partial-0123456789abcdef", "another's");
  put_bytes(folder / "out.ply.partial-backup", "a person's");
  const std::string base = "out.ply";
  EXPECT_TRUE(is_temporary_name_beside(mine.substr(folder.path().size() + 1), base));
  EXPECT_FALSE(is_temporary_name_beside("out.ply.partial-backup", base));
  EXPECT_FALSE(is_temporary_name_beside("out.ply", base));
  remove_left_beside(folder / "out.ply", mine);
  EXPECT_THAT(folder.names(),
              ElementsAre("out.ply", "out.ply.partial-0123456789abcdef", "out.ply.partial-backup"));
}

}  // namespace
}  // namespace stream_recon
