// The page of a run: its parts, and that no name can break out of it.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/io_test_folder.h"
#include "tools/html/chart.h"
#include "tools/html/plot.h"
#include "tools/html/run_page.h"
#include "tools/html/text.h"

namespace stream_recon::html {
namespace {

using testing::HasSubstr;
using testing::Not;

TEST(HtmlText, NamesStayText) {
  EXPECT_EQ(escape("<a href=\"x\">&'"), "&lt;a href=&quot;x&quot;&gt;&amp;&#39;");
  EXPECT_EQ(escape("tab\there\n"), "tab\xEF\xBF\xBDhere\xEF\xBF\xBD");
  EXPECT_EQ(escape("Gr\xC3\xB6\xC3\x9F\x65 \xE2\x86\x92 \xF0\x9F\xA6\xB4"),
            "Gr\xC3\xB6\xC3\x9F\x65 \xE2\x86\x92 \xF0\x9F\xA6\xB4");
}

TEST(HtmlText, WhatIsNoUtf8IsReplacedByteByByte) {
  const std::string no = "\xEF\xBF\xBD";
  EXPECT_EQ(escape("a\xFF\x62"), "a" + no + "b");
  EXPECT_EQ(escape("\xC3"), no);
  EXPECT_EQ(escape("\xC0\xBC"), no + no);           // an overlong '<'
  EXPECT_EQ(escape("\xE0\x80\xBC"), no + no + no);  // another
  EXPECT_EQ(escape("\xED\xA0\x80"), no + no + no);  // half a surrogate pair
  EXPECT_EQ(escape("\xF4\x90\x80\x80"), no + no + no + no);
  EXPECT_EQ(escape("\xE2\x86<"), no + no + "&lt;");
}

TEST(HtmlText, NumbersHaveSeparatorsAndUnits) {
  EXPECT_EQ(count(std::uint64_t{0}), "0");
  EXPECT_EQ(count(std::uint64_t{999}), "999");
  EXPECT_EQ(count(std::uint64_t{1000}), "1,000");
  EXPECT_EQ(count(std::uint64_t{1002003}), "1,002,003");
  EXPECT_EQ(count(UINT64_MAX), "18,446,744,073,709,551,615");
  EXPECT_EQ(count(std::int64_t{-6410}),
            "\xE2\x88\x92"
            "6,410");
  EXPECT_EQ(count(INT64_MIN),
            "\xE2\x88\x92"
            "9,223,372,036,854,775,808");
  EXPECT_EQ(bytes(1023), "1023 B");
  EXPECT_EQ(bytes(1024), "1.00 KiB");
  EXPECT_EQ(bytes(std::uint64_t{64} << 20), "64.0 MiB");
  EXPECT_EQ(bytes((std::uint64_t{1} << 30) - 1), "1.00 GiB");
  EXPECT_EQ(duration(0.0123), "12 ms");
  EXPECT_EQ(duration(0.9999), "1.00 s");
  EXPECT_EQ(duration(59.94), "59.9 s");
  EXPECT_EQ(duration(59.96), "1 min 00 s");
  EXPECT_EQ(duration(7384), "2 h 03 min");
  EXPECT_EQ(share(1, 8), "12.5 %");
  EXPECT_EQ(share(0, 0), "0.0 %");
}

TEST(HtmlText, Base64IsThatOfTheStandard) {
  EXPECT_EQ(base64(""), "");
  EXPECT_EQ(base64("f"), "Zg==");
  EXPECT_EQ(base64("fo"), "Zm8=");
  EXPECT_EQ(base64("foo"), "Zm9v");
  EXPECT_EQ(base64("foobar"), "Zm9vYmFy");
  EXPECT_EQ(base64("\xFF\xFE\xFD"), "//79");
}

TEST(Plot, StepsAreRound) {
  for (const double end : {1e-3, 0.7, 1.0, 12.0, 99.0, 1e9}) {
    const double step = round_step(end, 5);
    EXPECT_GE(end / step, 2) << end;
    EXPECT_LE(end / step, 5.01) << end;
  }
  EXPECT_EQ(round_step(12, 6), 2);
  EXPECT_EQ(round_step(0, 6), 1);
}

TEST(Charts, AreDrawnOfNothingToo) {
  EXPECT_THAT(memory_chart({}), HasSubstr("<svg"));
  EXPECT_THAT(delta_chart({}), HasSubstr("<svg"));
  for (const std::string& text : {memory_chart({}), delta_chart({})}) {
    EXPECT_THAT(text, Not(HasSubstr("nan")));
    EXPECT_THAT(text, Not(HasSubstr("inf")));
  }
}

std::size_t occurrences(const std::string& text, const std::string& part) {
  std::size_t count = 0;
  for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
  return count;
}

TEST(Charts, HaveABarForEachDegreeThatHasTriangles) {
  DeltaHistogram histogram{};
  histogram[3] = 7;
  histogram[89] = 1;
  EXPECT_EQ(occurrences(delta_chart(histogram), "<rect"), 2U);
  EXPECT_THAT(delta_chart(histogram), Not(HasSubstr("180")));
  histogram[120] = 1;
  EXPECT_THAT(delta_chart(histogram), HasSubstr("180"));
}

TEST(Charts, TheBudgetIsALineWhereItIsNear) {
  Report report;
  report.seconds = 2;
  report.peak_rss_bytes = std::uint64_t{40} << 20;
  report.memory_over_time = {{0, 1 << 20}, {1, 40 << 20}, {2, 1 << 20}};
  report.memory_budget_bytes = std::uint64_t{64} << 20;
  EXPECT_THAT(memory_chart(report), HasSubstr("budget 64.0 MiB"));
  report.memory_budget_bytes = std::uint64_t{64} << 30;
  EXPECT_THAT(memory_chart(report), HasSubstr("The budget, 64.0 GiB, lies far above"));
}

RunPage example() {
  RunPage page;
  page.report.version = "1.2.3";
  auto& surface = page.report.surface;
  surface.kind = "gamma";
  surface.vertices = 10;
  surface.triangles = 1234567;
  surface.digest = "0123456789abcdef";
  surface.boundary_edges = 3;
  surface.nonmanifold_edges = 4;
  surface.euler = -5;
  surface.components = 98765;
  page.report.stages = {{"ingest", 0, 0.5, 1, 2}};
  page.inputs = {"folder/cloud.ply"};
  page.outputs = {"out.pvtp"};
  page.command = {"stream-recon", "folder/cloud.ply"};
  return page;
}

TEST(RunPage, HasTheFigures) {
  const std::string text = run_page(example());
  for (const char* part : {"cloud.ply", "out.pvtp", "1,234,567", "0123456789abcdef",
                           "\xE2\x88\x92"
                           "5",
                           "ingest", "500 ms", "1.2.3"}) {
    EXPECT_THAT(text, HasSubstr(part));
  }
}

TEST(RunPage, NamesCannotBreakOut) {
  const std::string evil = "<script>alert('x')</script>\"onload=\"y";
  RunPage page = example();
  page.inputs = {evil};
  page.outputs = {evil};
  page.command = {evil};
  page.note = evil;
  page.report.version = evil;
  page.report.surface.kind = evil;
  page.report.surface.digest = evil;
  page.report.stages[0].name = evil;
  page.pictures.reason = evil;
  const std::string text = run_page(page);
  EXPECT_THAT(text, Not(HasSubstr("<script")));
  EXPECT_THAT(text, Not(HasSubstr("\"onload")));
  EXPECT_THAT(text, HasSubstr("&lt;script&gt;"));
}

TEST(RunPage, CommandsCanBeTypedAgain) {
  RunPage page = example();
  page.command = {"stream-recon", "two words.ply", "it's", "", "--memory", "64M"};
  EXPECT_THAT(run_page(page), HasSubstr("stream-recon &#39;two words.ply&#39; "
                                        "&#39;it&#39;\\&#39;&#39;s&#39; &#39;&#39; --memory 64M<"));
}

TEST(RunPage, IsCompleteUnderItsNameOrNotThere) {
  const TestFolder folder;
  write_run_page(example(), folder / "run.html");
  EXPECT_EQ(folder.names(), std::vector<std::string>{"run.html"});
  EXPECT_EQ(file_bytes(folder / "run.html"), run_page(example()));
}

}  // namespace
}  // namespace stream_recon::html
