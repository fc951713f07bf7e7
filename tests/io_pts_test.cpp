// The framed point stream: what is said about the points, and what must be refused.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "io/checksum.h"
#include "io/pts_encoder.h"
#include "io/pts_layout.h"
#include "io_reader_helpers.h"

namespace stream_recon {
namespace {

using testing::HasSubstr;

std::string stream_of(std::span<const Point3> points, const PointMetadata& metadata) {
  PtsEncoder encoder(Scalar::kFloat64);
  std::string bytes = encoder.header(metadata);
  for (const Point3& p : points) bytes += encoder.frame({&p, 1});
  return bytes + encoder.end();
}

class PtsStream : public testing::Test {
 protected:
  std::string error_of(const std::string& bytes) const {
    return file_.read(bytes, InputFormat::kAuto).error;
  }
  ByteFile file_;
  const std::vector<Point3> points_{{1, 2, 3}, {4, 5, 6}, {7, 8, 9}};
};

TEST_F(PtsStream, CarriesWhatIsKnownAboutThePoints) {
  file_.put(stream_of(points_, {SampleSpacing{0.5, 0.25, 1.5}, "head \"CT\"", "iso 100"}));
  const auto source = open_point_source(file_.path(), InputFormat::kAuto);
  EXPECT_EQ(source->metadata().spacing, (SampleSpacing{0.5, 0.25, 1.5}));
  EXPECT_EQ(source->metadata().source, "head \"CT\"");
  EXPECT_EQ(source->metadata().value, "iso 100");
}

TEST_F(PtsStream, MayKnowNothing) {
  file_.put(stream_of(points_, {}));
  const auto source = open_point_source(file_.path(), InputFormat::kAuto);
  EXPECT_FALSE(source->metadata().spacing.has_value());
  EXPECT_EQ(source->metadata().source, "");
}

TEST_F(PtsStream, TakesASourceOfAnyBytes) {
  file_.put(stream_of(points_, {{}, "\xff\xfe\n", ""}));
  EXPECT_THAT(open_point_source(file_.path(), InputFormat::kAuto)->metadata().source,
              HasSubstr("\n"));
}

TEST_F(PtsStream, WithoutPointsIsWhole) {
  const Outcome outcome = file_.read(stream_of({}, {}), InputFormat::kAuto);
  EXPECT_EQ(outcome.error, "");
  EXPECT_TRUE(outcome.points.empty());
}

TEST_F(PtsStream, CutBetweenFramesSaysThatItsWriterWasStopped) {
  PtsEncoder encoder(Scalar::kFloat64);
  const std::string bytes = encoder.header({}) + encoder.frame(points_);
  EXPECT_THAT(error_of(bytes), HasSubstr("without its end frame, after 3 points"));
}

TEST_F(PtsStream, NoticesEveryFlippedBit) {
  const std::string whole = stream_of(points_, {SampleSpacing{1, 1, 2}, "a", "b"});
  for (std::size_t bit = 0; bit < 8 * whole.size(); ++bit) {
    std::string damaged = whole;
    damaged[bit / 8] = static_cast<char>(damaged[bit / 8] ^ 1 << bit % 8);
    EXPECT_NE(file_.read(damaged, InputFormat::kPts).error, "") << "bit " << bit;
  }
}

TEST_F(PtsStream, WithAFrameLostRepeatedOrOutOfPlaceIsRefused) {
  PtsEncoder encoder(Scalar::kFloat64);
  const std::string header = encoder.header({});
  const std::string a = encoder.frame({points_.data(), 1});
  const std::string b = encoder.frame({points_.data() + 1, 1});
  const std::string end = encoder.end();
  EXPECT_EQ(error_of(header + a + b + end), "");
  for (const std::string& frames : {a + end, b + end, a + a + b + end, b + a + end, end}) {
    EXPECT_THAT(error_of(header + frames), HasSubstr("no frame of a point stream begins here"));
  }
}

TEST_F(PtsStream, ThatGoesOnBehindItsEndIsRefused) {
  const std::string whole = stream_of(points_, {});
  EXPECT_THAT(error_of(whole + whole), HasSubstr("bytes follow"));
  EXPECT_THAT(error_of(whole + "\n"), HasSubstr("bytes follow"));
}

TEST_F(PtsStream, WithASpacingThatIsNoneIsRefused) {
  for (const double spacing : {0.0, -1.0, std::numeric_limits<double>::quiet_NaN()}) {
    EXPECT_THAT(error_of(stream_of(points_, {SampleSpacing{1, spacing, 1}, "", ""})),
                HasSubstr("metadata"))
        << spacing;
  }
}

TEST_F(PtsStream, OfALaterVersionSaysWhatToDo) {
  std::string bytes = stream_of(points_, {});
  bytes[kPtsMagic.size()] = 2;
  EXPECT_THAT(error_of(bytes), HasSubstr("update stream-recon"));
}

}  // namespace
}  // namespace stream_recon
