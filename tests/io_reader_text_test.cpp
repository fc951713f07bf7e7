// Texts of points as people really write them: what is read, and what is refused with its line.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "io/number_text.h"
#include "io_reader_helpers.h"

namespace stream_recon {
namespace {

class XyzText : public ::testing::Test {
 protected:
  std::vector<Point3> points(const std::string& text) const {
    const Outcome outcome = file_.read(text, InputFormat::kXyz);
    EXPECT_EQ(outcome.error, "") << text;
    return outcome.points;
  }
  void expect_refused(const std::string& text, const std::string& line,
                      const std::string& why) const {
    const Outcome outcome = file_.read(text, InputFormat::kXyz);
    EXPECT_NE(outcome.error.find("line " + line + ": "), std::string::npos) << outcome.error;
    EXPECT_NE(outcome.error.find(why), std::string::npos) << outcome.error;
  }
  ByteFile file_;
};

TEST_F(XyzText, WithoutPointsIsNoPoints) {
  EXPECT_TRUE(points("").empty());
  EXPECT_TRUE(points("# nothing\n\n \t\n//").empty());
  EXPECT_TRUE(points("x y z\n").empty());
}

TEST_F(XyzText, MayLackTheLastLineEnd) {
  EXPECT_EQ(points("1 2 3\n4 5 6").size(), 2U);
  EXPECT_EQ(points("1 2 3 255\n4 5 6 255 # last").size(), 2U);
}

TEST_F(XyzText, WithFewerColumnsInAnOpenLastLineIsCut) {
  expect_refused("1 2 3 255\n4 5 6", "2", "digits may be missing");
}

TEST_F(XyzText, GivesNonFiniteValuesAsTheyAre) {
  const auto read = points("nan 1 2\n-INF +inf Infinity\nNaN nan -nan\n1e999 -1e999 1e-999\n");
  ASSERT_EQ(read.size(), 4U);
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  EXPECT_TRUE(std::isnan(read[0].x));
  EXPECT_EQ(read[1], (Point3{-kInfinity, kInfinity, kInfinity}));
  EXPECT_TRUE(std::isnan(read[2].x) && std::isnan(read[2].y) && std::isnan(read[2].z));
  EXPECT_EQ(read[3], (Point3{kInfinity, -kInfinity, 0}));
}

TEST_F(XyzText, RefusesDecimalCommas) {
  expect_refused("1,5;2,5;3,5\n", "1", "decimal points");
  expect_refused("1,5 2,5 3,5\n", "1", "should be a number");
  expect_refused("1;2;3\n1,5;2,5;3,5\n", "2", "should be a number");
  expect_refused("1 2 3\n1,5 2,5 3,5\n", "2", "should be a number");
}

TEST_F(XyzText, RefusesWhatIsNoNumber) {
  expect_refused("1 2 3\n\n# a\n1 2 x3\n", "4", "\"x3\" where column 3");
  expect_refused("1 2 3\n1.0D+03 2 3\n", "2", "\"1.0D+03\"");
  expect_refused("1 2 3\n0x10 2 3\n", "2", "\"0x10\"");
  expect_refused("1 2 3\n1 2 3.4.5\n", "2", "\"3.4.5\"");
  expect_refused("1 2 3\n1 +-2 3\n", "2", "\"+-2\"");
  expect_refused("1,2,3\n1,,3\n", "2", "an empty column");
  expect_refused(std::string("1 2 3\n1 2 \0\n", 12), "2", "\"?\"");
}

TEST_F(XyzText, RefusesTooFewColumns) {
  expect_refused("1 2 3\n4 5\n", "2", "2 columns, too few");
  expect_refused("1 2\n", "1", "2 columns, too few");
  expect_refused("1 2 3\n4 5 # 6\n", "2", "2 columns, too few");
}

TEST_F(XyzText, OfAMoleculeIsRefused) {
  expect_refused("2\nwater\nO 0 0 0\nH 0 0 1\n", "2", "columns x, y, z");
  expect_refused("2\n\nO 0 0 0\nH 0 0 1\n", "3", "columns x, y, z");
}

TEST_F(XyzText, WithACountMustKeepIt) {
  EXPECT_EQ(points("2\n1 2 3\n4 5 6\n").size(), 2U);
  EXPECT_EQ(points("0\n").size(), 0U);
  expect_refused("3\n1 2 3\n4 5 6\n", "3", "before the 3 points");
  expect_refused("1\n1 2 3\n4 5 6\n", "3", "more points than the 1");
  expect_refused("7\n", "1", "before the 7 points");
  expect_refused("1\n1 2 3", "2", "digits may be missing");
}

TEST_F(XyzText, FindsColumnsByName) {
  EXPECT_EQ(points("Intensity,Points:0,Points:1,Points:2\n9,1,2,3\n"),
            (std::vector<Point3>{{1, 2, 3}}));
  EXPECT_EQ(points("# z y x\n1 2 3\n"), (std::vector<Point3>{{3, 2, 1}}));
  EXPECT_EQ(points("# z y x of a cloud\n1 2 3\n"), (std::vector<Point3>{{1, 2, 3}}));
  expect_refused("east north height\n1 2 3\n", "1", "columns x, y, z");
  expect_refused("x y z x\n1 2 3 4\n", "1", "columns x, y, z");
  expect_refused("id x y z\n1 2 3\n", "2", "3 columns, too few");
}

TEST_F(XyzText, RefusesLoneCarriageReturns) {
  expect_refused("1 2 3\r4 5 6\r", "1", "carriage return");
}

TEST_F(XyzText, RefusesALineLongerThanTheWindow) {
  expect_refused("1 2 3\n1 2 3 " + std::string(1 << 20, 'x') + "\n", "2", "longer than");
  EXPECT_EQ(points("1 2 3\n1 2 3 " + std::string(1 << 17, 'x') + "\n4 5 6\n").size(), 3U);
}

TEST_F(XyzText, LongerThanTheWindowIsReadToTheEnd) {
  std::string text;
  constexpr int kPoints = 100000;
  for (int i = 0; i < kPoints; ++i) text += std::to_string(i) + " 0.5 -1\n";
  const auto read = points(text);
  ASSERT_EQ(read.size(), kPoints);
  for (int i = 0; i < kPoints; ++i) ASSERT_EQ(read[static_cast<std::size_t>(i)].x, i);
}

TEST(NumberText, IsTheNearestValue) {
  EXPECT_EQ(whole_double("0.1"), 0.1);
  EXPECT_EQ(whole_double("9007199254740993"), 9007199254740992.0);
  EXPECT_EQ(whole_double("2.2250738585072011e-308"), 2.2250738585072011e-308);
  EXPECT_EQ(whole_double("4.9e-324"), std::numeric_limits<double>::denorm_min());
  EXPECT_EQ(whole_float("0.1"), static_cast<double>(0.1F));
  // A rounding through double would give the float above.
  EXPECT_EQ(whole_float("1.00000017881393432617187499"), 1.0000001192092896);
  EXPECT_EQ(whole_double(""), std::nullopt);
  EXPECT_EQ(whole_double("1 "), std::nullopt);
  EXPECT_EQ(whole_count("-1"), std::nullopt);
  EXPECT_EQ(whole_count("18446744073709551616"), std::nullopt);
}

TEST(QuotedText, IsOnePrintableLine) {
  EXPECT_EQ(quote_text("a\nb"), "\"a?b\"");
  EXPECT_EQ(quote_text(std::string(50, 'a')), "\"" + std::string(40, 'a') + "...\"");
}

}  // namespace
}  // namespace stream_recon
