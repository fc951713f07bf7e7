// Writers of surfaces: complete or absent, whatever fails; the same bytes for the same chunks.
#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <map>
#include <string>
#include <thread>
#include <vector>

#include "io/error.h"
#include "io/fault_injection.h"
#include "io/scratch_directory.h"
#include "tests/io_test_folder.h"
#include "tests/io_writer_surface.h"

namespace stream_recon {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

/// Every file below a folder, by relative path.
std::map<std::string, std::string> contents(const std::string& folder) {
  std::map<std::string, std::string> files;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    const std::string name = std::filesystem::relative(entry.path(), folder).string();
    files[name] = entry.is_directory() ? "folder" : file_bytes(entry.path().string());
  }
  return files;
}

class Writer : public testing::TestWithParam<std::string> {
 protected:
  std::uint64_t write(const std::string& folder, const std::vector<SurfaceChunk>& surface) {
    ScratchDirectory scratch({scratch_.path()});
    return write_surface(surface, {folder + "/" + GetParam(), Scalar::kFloat64, &scratch});
  }

  TestFolder scratch_;
  const std::vector<SurfaceChunk> old_surface_ = make_surface(3, 40, Scalar::kFloat64, 1);
  const std::vector<SurfaceChunk> new_surface_ = make_surface(2, 50, Scalar::kFloat64, 2);
};

TEST_P(Writer, WritesTheSameBytesForTheSameChunks) {
  const TestFolder first;
  const TestFolder second;
  write(first.path(), old_surface_);
  write(second.path(), old_surface_);
  EXPECT_EQ(contents(first.path()), contents(second.path()));
}

TEST_P(Writer, CountsTheBytesOfTheResult) {
  const TestFolder folder;
  const std::uint64_t counted = write(folder.path(), old_surface_);
  std::uint64_t found = 0;
  for (const auto& [name, bytes] : contents(folder.path())) {
    if (bytes != "folder") found += bytes.size();
  }
  EXPECT_EQ(counted, found);
}

TEST_P(Writer, ReplacesAnOlderResultWhole) {
  const TestFolder folder;
  const TestFolder fresh;
  write(folder.path(), old_surface_);
  write(folder.path(), new_surface_);
  write(fresh.path(), new_surface_);
  EXPECT_EQ(contents(folder.path()), contents(fresh.path()));
}

TEST_P(Writer, LeavesNothingAndKeepsTheOlderResultWhenDestroyedBeforeFinish) {
  const TestFolder folder;
  write(folder.path(), old_surface_);
  const auto before = contents(folder.path());
  ScratchDirectory scratch({scratch_.path()});
  make_surface_writer({folder / GetParam(), Scalar::kFloat64, &scratch})->write(0, new_surface_[0]);
  EXPECT_EQ(contents(folder.path()), before);
  EXPECT_EQ(scratch.used_bytes(), 0U);
}

constexpr auto bit(IoOperation operation) {
  return static_cast<unsigned>(operation);
}
constexpr unsigned kEverything = bit(IoOperation::kOpen) | bit(IoOperation::kRead) |
                                 bit(IoOperation::kWrite) | bit(IoOperation::kSync) |
                                 bit(IoOperation::kRename) | bit(IoOperation::kMakeDirectory) |
                                 bit(IoOperation::kClose);

/// A failing run, over an older result or none, for the failure of call 0, 1, 2 and so on.
class FailingWriter : public Writer {
 protected:
  void fail_every_call(FaultPlan plan, bool has_older_result) {
    for (bool fired = true; fired; ++plan.fail_at) {
      SCOPED_TRACE("failing call " + std::to_string(plan.fail_at));
      const TestFolder folder;
      if (has_older_result) write(folder.path(), old_surface_);
      const auto before = contents(folder.path());
      bool is_told = false;
      {
        const ScopedFault fault(plan);
        try {
          write(folder.path(), new_surface_);
        } catch (const IoError&) {
          is_told = true;
        }
        fired = fault.fired();
      }
      ASSERT_EQ(is_told, fired);
      ASSERT_TRUE(scratch_.names().empty());
      if (!fired) break;
      const auto after = contents(folder.path());
      ASSERT_TRUE(after.empty() || after == before) << testing::PrintToString(folder.names());
    }
    EXPECT_GT(plan.fail_at, 8U) << "the plan met hardly any call";
  }
};

TEST_P(FailingWriter, TellsEveryFailedCallAndLeavesNothing) {
  fail_every_call({kEverything, 0, EIO}, false);
}

TEST_P(FailingWriter, TellsEveryFailedCallAndLeavesTheOlderResultOrNone) {
  fail_every_call({kEverything, 0, EIO}, true);
}

TEST_P(FailingWriter, LeavesNothingWhenTheDiskIsFullFromSomeWriteOn) {
  fail_every_call({bit(IoOperation::kWrite) | bit(IoOperation::kOpen), 0, ENOSPC, true}, true);
}

INSTANTIATE_TEST_SUITE_P(Formats, Writer, testing::Values("a.pvtp", "a.ply", "a.vtk"));
INSTANTIATE_TEST_SUITE_P(Formats, FailingWriter, testing::Values("a.pvtp", "a.ply", "a.vtk"));

TEST(PvtpWriter, KeepsTheOlderResultWhateverFails) {
  for (std::uint64_t n = 0;; ++n) {
    SCOPED_TRACE("failing call " + std::to_string(n));
    const TestFolder folder;
    write_surface(make_surface(2, 10, Scalar::kFloat64, 1), {folder / "a.pvtp"});
    const auto before = contents(folder.path());
    const ScopedFault fault({kEverything, n, ENOSPC});
    try {
      write_surface(make_surface(1, 10, Scalar::kFloat64, 2), {folder / "a.pvtp"});
      break;
    } catch (const IoError&) {
      ASSERT_EQ(contents(folder.path()), before);
    }
  }
}

TEST(PvtpWriter, RefusesAFolderThatHoldsOtherThingsAndTouchesNothing) {
  const TestFolder folder;
  make_folder(folder / "brain");
  put_bytes(folder / "brain/chunk_000000.vtp", "chunk");
  put_bytes(folder / "brain/slice_17.dcm", "precious");
  const auto before = contents(folder.path());
  EXPECT_THAT([&] { make_surface_writer({folder / "brain.pvtp"}); },
              ThrowsMessage<IoError>(HasSubstr("slice_17.dcm")));
  EXPECT_EQ(contents(folder.path()), before);
}

TEST(PvtpWriter, RefusesToReplaceAFileThatStandsWhereTheFolderGoes) {
  const TestFolder folder;
  put_bytes(folder / "brain", "precious");
  EXPECT_THROW(make_surface_writer({folder / "brain.pvtp"}), IoError);
  EXPECT_EQ(file_bytes(folder / "brain"), "precious");
}

TEST(PvtpWriter, ShowsNoIndexBeforeFinish) {
  const TestFolder folder;
  const auto writer = make_surface_writer({folder / "a.pvtp"});
  writer->write(0, make_surface(1, 10, Scalar::kFloat64, 1)[0]);
  EXPECT_FALSE(path_exists(folder / "a.pvtp"));
  EXPECT_FALSE(path_exists(folder / "a"));
  writer->finish();
  EXPECT_THAT(folder.names(), testing::ElementsAre("a", "a.pvtp"));
}

/// Standard output goes elsewhere while this lives.
class RedirectedOutput {
 public:
  explicit RedirectedOutput(int descriptor) {
    std::fflush(stdout);
    saved_ = ::dup(STDOUT_FILENO);
    ::dup2(descriptor, STDOUT_FILENO);
    ::close(descriptor);
  }
  ~RedirectedOutput() {
    ::dup2(saved_, STDOUT_FILENO);
    ::close(saved_);
  }

 private:
  int saved_;
};

class PlyStream : public testing::Test {
 protected:
  PlyStream() {
    write_surface(surface_, {folder_ / "a.ply", Scalar::kFloat64, &scratch_});
    file_ = file_bytes(folder_ / "a.ply");
  }
  void stream() { write_surface(surface_, {"-", Scalar::kFloat64, &scratch_}); }

  TestFolder folder_;
  ScratchDirectory scratch_{{folder_.path()}};
  const std::vector<SurfaceChunk> surface_ = make_surface(3, 5000, Scalar::kFloat64, 3);
  std::string file_;
};

TEST_F(PlyStream, HasTheBytesOfTheFile) {
  {
    const RedirectedOutput redirected(
        ::open((folder_ / "stream").c_str(), O_WRONLY | O_CREAT | O_CLOEXEC, 0600));
    stream();
  }
  EXPECT_TRUE(file_bytes(folder_ / "stream") == file_);
}

TEST_F(PlyStream, WaitsForAPipeThatDoesNotBlock) {
  std::array<int, 2> ends{};
  ASSERT_EQ(::pipe2(ends.data(), O_CLOEXEC | O_NONBLOCK), 0);
  std::string received;
  {
    std::jthread reader([&] {
      std::array<char, 1000> some{};
      ssize_t got = 0;
      while ((got = ::read(ends[0], some.data(), some.size())) != 0) {
        if (got > 0) received.append(some.data(), static_cast<std::size_t>(got));
        if (got < 0) ::usleep(100);
      }
    });
    const RedirectedOutput redirected(ends[1]);
    stream();
  }
  ::close(ends[0]);
  EXPECT_TRUE(received == file_);
}

TEST_F(PlyStream, SaysSoWhenNobodyReadsThePipe) {
  std::array<int, 2> ends{};
  ASSERT_EQ(::pipe2(ends.data(), O_CLOEXEC), 0);
  ::close(ends[0]);
  ::signal(SIGPIPE, SIG_IGN);
  const RedirectedOutput redirected(ends[1]);
  EXPECT_THAT([&] { stream(); }, ThrowsMessage<IoError>(HasSubstr("standard output: Broken pipe")));
}

TEST(PlyWriter, HoldsTheCoordinatesOfEachVertexOnceBitForBit) {
  const TestFolder folder;
  ScratchDirectory scratch({folder.path()});
  const auto surface = make_surface(2, 100, Scalar::kFloat64, 4);
  write_surface(surface, {folder / "a.ply", Scalar::kFloat64, &scratch});
  const std::string file = file_bytes(folder / "a.ply");
  const std::size_t body = file.find("end_header\n") + 11;
  std::uint64_t vertices = 0;
  for (const SurfaceChunk& chunk : surface) {
    for (std::size_t i = 0; i < chunk.points.size(); ++i) {
      Point3 read;
      std::memcpy(&read, file.data() + body + chunk.vertex_numbers[i] * sizeof read, sizeof read);
      ASSERT_EQ(read, chunk.points[i]);
      vertices = std::max(vertices, chunk.vertex_numbers[i] + 1);
    }
  }
  EXPECT_NE(file.find("element vertex " + std::to_string(vertices) + "\n"), std::string::npos);
  EXPECT_EQ(file.size(), body + vertices * 24 + 2 * 100 * 13);
}

TEST(SurfaceWriter, RefusesNamesItHasNoFormatFor) {
  EXPECT_THROW(make_surface_writer({"a.stl"}), std::invalid_argument);
  EXPECT_THROW(make_surface_writer({"a.ply"}), std::invalid_argument);  // no scratch
  EXPECT_THROW(make_surface_writer({".pvtp"}), std::invalid_argument);
}

TEST(SurfaceWriter, ToldAtTheStartThatTheFolderDoesNotExist) {
  const TestFolder folder;
  ScratchDirectory scratch({folder.path()});
  for (const char* name : {"none/a.pvtp", "none/a.ply", "none/a.vtk"}) {
    EXPECT_THAT(
        [&] {
          make_surface_writer({folder / name, Scalar::kFloat64, &scratch});
        },
        ThrowsMessage<IoError>(HasSubstr("create the folder")));
  }
}

}  // namespace
}  // namespace stream_recon
