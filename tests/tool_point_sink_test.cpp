#include "tools/points/point_sink.h"

#include <gtest/gtest.h>

#include <bit>
#include <cstdlib>
#include <filesystem>
#include <limits>
#include <sstream>
#include <vector>

#include "io/error.h"
#include "io/point_source.h"
#include "tests/io_test_folder.h"

namespace stream_recon {
namespace {

class PointSinkTest : public testing::Test {
 protected:
  std::string path(const std::string& name) const { return folder_ / name; }

  std::string written(PointFormat format, Scalar scalar = Scalar::kFloat64) const {
    PointSink sink({path("points"), format, scalar, points_.size()});
    sink.write(points_);
    sink.finish();
    return file_bytes(path("points"));
  }

  template <typename Real>
  std::string raw() const {
    std::string bytes;
    for (const Point3& p : points_)
      for (const double value : {p.x, p.y, p.z}) {
        const auto real = static_cast<Real>(value);
        bytes.append(reinterpret_cast<const char*>(&real), sizeof real);
      }
    return bytes;
  }

  bool folder_is_empty() const { return folder_.names().empty(); }

  std::vector<Point3> points_{{0.1, -2, 3e-310}, {1e300, 7, -0.0}};

 private:
  TestFolder folder_;
};

TEST_F(PointSinkTest, RawFormatsAreTheCoordinates) {
  points_[1].x = 1e30;
  EXPECT_EQ(written(PointFormat::kF32), raw<float>());
  EXPECT_EQ(written(PointFormat::kF64), raw<double>());
}

TEST_F(PointSinkTest, PlyIsHeaderAndCoordinates) {
  const auto header = [](const std::string& type) {
    return "ply\nformat binary_little_endian 1.0\nelement vertex 2\nproperty " + type +
           " x\nproperty " + type + " y\nproperty " + type + " z\nend_header\n";
  };
  points_[1].x = 1e30;
  EXPECT_EQ(written(PointFormat::kPly), header("double") + raw<double>());
  EXPECT_EQ(written(PointFormat::kPly, Scalar::kFloat32), header("float") + raw<float>());
}

TEST_F(PointSinkTest, APlyFileCountsItsPointsAtTheEnd) {
  for (const std::size_t count : {0, 1, 9, 10, 12345}) {
    points_.assign(count, {1, 2, 3});
    PointSink sink({path("late.ply"), PointFormat::kPly, Scalar::kFloat32});
    sink.write(points_);
    sink.finish();
    const auto source = open_point_source(path("late.ply"), InputFormat::kAuto);
    EXPECT_EQ(source->announced_count(), count);
    std::vector<Point3> read(count + 1);
    EXPECT_EQ(source->read(read), count);
  }
}

TEST_F(PointSinkTest, FramesHoldEveryPointAndWhatIsKnownOfThem) {
  for (const std::size_t count : {0, 1, 16383, 16384, 16385, 40000}) {
    points_.clear();
    for (std::size_t i = 0; i < count; ++i) points_.push_back({static_cast<double>(i), 0.1, 2});
    PointSink sink({.path = path("points"),
                    .format = PointFormat::kPts,
                    .metadata = {SampleSpacing{1, 2, 3}, "head", "iso 5"}});
    sink.write(points_);
    sink.finish();
    const auto source = open_point_source(path("points"), InputFormat::kAuto);
    EXPECT_EQ(source->metadata().spacing, (SampleSpacing{1, 2, 3}));
    EXPECT_EQ(source->metadata().value, "iso 5");
    std::vector<Point3> read(count + 1);
    EXPECT_EQ(source->read(read), count);
    read.resize(count);
    EXPECT_TRUE(read == points_);
  }
}

TEST_F(PointSinkTest, TextReadsBackAsTheSameBits) {
  std::istringstream text(written(PointFormat::kXyz));
  for (const Point3& p : points_)
    for (const double expected : {p.x, p.y, p.z}) {
      std::string word;
      text >> word;
      EXPECT_EQ(std::bit_cast<std::uint64_t>(std::strtod(word.c_str(), nullptr)),
                std::bit_cast<std::uint64_t>(expected));
    }
}

TEST_F(PointSinkTest, NothingStandsUnderTheNameBeforeTheEnd) {
  {
    PointSink sink({path("points"), PointFormat::kF64});
    sink.write(std::vector<Point3>(100000));
    EXPECT_FALSE(std::filesystem::exists(path("points")));
  }
  EXPECT_TRUE(folder_is_empty());
}

TEST_F(PointSinkTest, AWrongCountInThePlyHeaderIsOurSlipAndLeavesNothing) {
  {
    PointSink sink({path("points"), PointFormat::kPly, Scalar::kFloat64, 3});
    sink.write(points_);
    EXPECT_THROW(sink.finish(), std::logic_error);
  }
  EXPECT_TRUE(folder_is_empty());
}

TEST_F(PointSinkTest, PlacesThatCannotTakeAFileAreRefusedAtOnce) {
  EXPECT_THROW(PointSink({path("missing/points"), PointFormat::kF64}), IoError);
  EXPECT_THROW(PointSink({path(""), PointFormat::kF64}), IoError);
  EXPECT_THROW(PointSink({"/dev/full", PointFormat::kF64}), IoError);
}

TEST(PointFormatOf, FollowsTheNamesEnding) {
  EXPECT_EQ(point_format_of("a.xyz"), PointFormat::kXyz);
  EXPECT_EQ(point_format_of("a.f32"), PointFormat::kF32);
  EXPECT_EQ(point_format_of("a.f64"), PointFormat::kF64);
  EXPECT_EQ(point_format_of("a.pts"), PointFormat::kPts);
  EXPECT_EQ(point_format_of("-"), PointFormat::kPly);
}

}  // namespace
}  // namespace stream_recon
