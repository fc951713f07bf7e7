// The writer of points: whole or not there, in the order of its chunks, whatever fails.

#include "io/points_writer.h"

#include <gtest/gtest.h>

#include <cerrno>
#include <string>
#include <thread>
#include <vector>

#include "io/error.h"
#include "io/fault_injection.h"
#include "io/folder.h"
#include "io/point_source.h"
#include "tests/io_test_folder.h"

namespace stream_recon {
namespace {

std::vector<Point3> points_of(std::uint64_t chunk) {
  std::vector<Point3> points;
  for (std::uint64_t i = 0; i < chunk % 5 * 1000; ++i) {
    points.push_back({static_cast<double>(chunk), static_cast<double>(i), 0.1});
  }
  return points;
}

TEST(PointsWriter, KeepsTheOrderOfTheChunksHoweverTheyCome) {
  const TestFolder folder;
  ScratchDirectory scratch({folder.path()});
  PointsWriter writer({folder / "a.ply", Scalar::kFloat64, &scratch});
  {
    std::vector<std::jthread> threads;
    for (std::uint64_t t = 0; t < 3; ++t) {
      threads.emplace_back([&writer, t] {
        for (std::uint64_t chunk = 20 - t; chunk < 21; chunk -= 3) {
          writer.write(chunk, points_of(chunk));
        }
      });
    }
  }
  writer.prepare();
  EXPECT_FALSE(path_exists(folder / "a.ply"));
  writer.publish();
  writer.keep();
  std::vector<Point3> expected;
  for (std::uint64_t chunk = 0; chunk < 21; ++chunk) {
    for (const Point3& p : points_of(chunk)) expected.push_back(p);
  }
  const auto source = open_point_source(folder / "a.ply", InputFormat::kAuto);
  std::vector<Point3> read(expected.size() + 1);
  std::size_t count = 0;
  while (const std::size_t got = source->read(std::span(read).subspan(count))) count += got;
  read.resize(count);
  EXPECT_EQ(read == expected, true);
  EXPECT_EQ(scratch.used_bytes(), 0U);
}

TEST(PointsWriter, OfNoPointsIsAnEmptyCloud) {
  const TestFolder folder;
  ScratchDirectory scratch({folder.path()});
  PointsWriter writer({folder / "a.ply", Scalar::kFloat32, &scratch});
  writer.prepare();
  writer.publish();
  writer.keep();
  EXPECT_NE(file_bytes(folder / "a.ply").find("element vertex 0\n"), std::string::npos);
}

TEST(PointsWriter, PutsTheOlderFileBackUnlessItIsKept) {
  const TestFolder folder;
  ScratchDirectory scratch({folder.path()});
  put_bytes(folder / "a.ply", "older");
  const auto names = folder.names();
  {
    PointsWriter writer({folder / "a.ply", Scalar::kFloat64, &scratch});
    writer.write(0, points_of(1));
    writer.prepare();
    writer.publish();
    EXPECT_EQ(file_bytes(folder / "a.ply").substr(0, 3), "ply");
  }
  EXPECT_EQ(file_bytes(folder / "a.ply"), "older");
  EXPECT_EQ(folder.names(), names);
}

TEST(PointsWriter, TellsEveryFailedCallAndKeepsTheOlderFile) {
  constexpr auto kCounted =
      static_cast<unsigned>(IoOperation::kOpen) | static_cast<unsigned>(IoOperation::kRead) |
      static_cast<unsigned>(IoOperation::kWrite) | static_cast<unsigned>(IoOperation::kSync) |
      static_cast<unsigned>(IoOperation::kRename) | static_cast<unsigned>(IoOperation::kClose);
  std::uint64_t failures = 0;
  for (bool fired = true; fired; ++failures) {
    const TestFolder folder;
    ScratchDirectory scratch({folder.path()});
    put_bytes(folder / "a.ply", "older");
    const auto names = folder.names();
    const ScopedFault fault({kCounted, failures, ENOSPC});
    bool is_told = false;
    try {
      PointsWriter writer({folder / "a.ply", Scalar::kFloat64, &scratch});
      writer.write(2, points_of(2));
      writer.write(1, points_of(1));
      writer.prepare();
      writer.publish();
      writer.keep();
    } catch (const IoError&) {
      is_told = true;
    }
    fired = fault.fired();
    ASSERT_EQ(is_told, fired) << failures;
    ASSERT_EQ(folder.names(), names) << failures;
    ASSERT_TRUE(scratch.names().empty());
    ASSERT_EQ(file_bytes(folder / "a.ply") == "older", fired) << failures;
  }
  EXPECT_GT(failures, 8U) << "the plan met hardly any call";
}

TEST(PointsWriter, RefusesWhatIsNoFile) {
  const TestFolder folder;
  ScratchDirectory scratch({folder.path()});
  EXPECT_THROW(PointsWriter({folder.path(), Scalar::kFloat64, &scratch}), IoError);
  EXPECT_THROW(PointsWriter({"/dev/null", Scalar::kFloat64, &scratch}), IoError);
  EXPECT_TRUE(scratch.names().empty());
}

}  // namespace
}  // namespace stream_recon
