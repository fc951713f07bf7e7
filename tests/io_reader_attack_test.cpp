// What every reader must do with its whole file, with each part of it, and with damaged headers.
#include <gtest/gtest.h>

#include <algorithm>

#include "io_reader_cases.h"
#include "io_reader_helpers.h"

namespace stream_recon {
namespace {

class Reader : public ::testing::TestWithParam<ReaderCase> {
 protected:
  InputFormat sniffed() const {
    const InputFormat format = GetParam().format;
    return format == InputFormat::kF32 || format == InputFormat::kF64 ? format : InputFormat::kAuto;
  }
  ByteFile file_;
};

TEST_P(Reader, GivesExactValues) {
  const Outcome outcome = file_.read(GetParam().bytes, sniffed());
  EXPECT_EQ(outcome.error, "");
  EXPECT_TRUE(same_bits(outcome.points, GetParam().points))
      << ::testing::PrintToString(outcome.points.size()) << " points";
  EXPECT_EQ(outcome.announced.value_or(GetParam().points.size()), GetParam().points.size());
}

TEST_P(Reader, GivesTheSameOnePointAtATime) {
  const Outcome outcome = file_.read(GetParam().bytes, GetParam().format, 1);
  EXPECT_EQ(outcome.error, "");
  EXPECT_TRUE(same_bits(outcome.points, GetParam().points));
}

TEST_P(Reader, GivesTheSameFromAPipeInBytes) {
  const FedPipe pipe(GetParam().bytes, 1);
  const Outcome outcome = read_path(pipe.path(), sniffed());
  EXPECT_EQ(outcome.error, "");
  EXPECT_TRUE(same_bits(outcome.points, GetParam().points));
}

TEST_P(Reader, NoticesEveryCut) {
  const ReaderCase& whole = GetParam();
  for (std::size_t length = 0; length < whole.bytes.size(); ++length) {
    SCOPED_TRACE("cut to " + std::to_string(length) + " of " + std::to_string(whole.bytes.size()));
    const Outcome outcome = file_.read(whole.bytes.substr(0, length), whole.format);
    if (!outcome.error.empty()) {
      EXPECT_NE(outcome.error.find(file_.path()), std::string::npos) << outcome.error;
      EXPECT_EQ(outcome.error.find('\n'), std::string::npos) << outcome.error;
    } else if (whole.counted) {
      // A text that lost even its count is an empty text.
      EXPECT_TRUE(same_bits(outcome.points, whole.points) ||
                  (length == 0 && whole.format == InputFormat::kXyz))
          << outcome.points.size() << " points";
    } else {
      // Without a count the last number may have lost digits, but nothing before it.
      ASSERT_LE(outcome.points.size(), whole.points.size());
      for (std::size_t i = 0; i + 1 < outcome.points.size(); ++i) {
        EXPECT_EQ(outcome.points[i], whole.points[i]);
      }
    }
  }
}

TEST_P(Reader, SurvivesEveryFlippedBitOfTheHeader) {
  const ReaderCase& whole = GetParam();
  std::size_t refused = 0;
  for (std::size_t bit = 0; bit < 8 * whole.header; ++bit) {
    std::string damaged = whole.bytes;
    damaged[bit / 8] = static_cast<char>(damaged[bit / 8] ^ 1 << bit % 8);
    const Outcome outcome = file_.read(damaged, whole.format);
    refused += outcome.error.empty() ? 0 : 1;
    // A header can hide points, never make more of them than there are bytes.
    EXPECT_LE(outcome.points.size(), whole.bytes.size() / 3) << "bit " << bit;
  }
  const bool has_magic = whole.format != InputFormat::kXyz;
  EXPECT_GE(refused, has_magic ? whole.header : 0);
}

TEST_P(Reader, SurvivesEveryOverwrittenByte) {
  const ReaderCase& whole = GetParam();
  for (std::size_t at = 0; at < whole.bytes.size(); ++at) {
    for (const char c : {'\0', '\xff', '9', '\n', '<', '>'}) {
      std::string damaged = whole.bytes;
      damaged[at] = c;
      const Outcome outcome = file_.read(damaged, whole.format);
      EXPECT_LE(outcome.points.size(), whole.bytes.size() / 3) << "byte " << at;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Formats, Reader, ::testing::ValuesIn(reader_cases()),
                         [](const auto& tested) { return tested.param.name; });

}  // namespace
}  // namespace stream_recon
