// stream-recon --html: what the page holds, when there is none, and how a browser shows it.

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <png.h>
#include <sys/resource.h>

#include <regex>
#include <set>
#include <string>
#include <vector>

#include "tests/cli_program.h"
#include "tests/process_memory_check.h"

namespace stream_recon {
namespace {

using testing::HasSubstr;
using testing::Not;

std::string with_commas(std::uint64_t number) {
  std::string text = std::to_string(number);
  for (std::size_t at = text.size(); at > 3;) text.insert(at -= 3, 1, ',');
  return text;
}

/// What else a page would have to load.
void expect_self_contained(const std::string& page) {
  for (const char* part : {"http:", "https:", "<script", "<link rel=\"stylesheet", "@import",
                           "url(", "<iframe", "<object"}) {
    EXPECT_THAT(page, Not(HasSubstr(part)));
  }
  const std::regex address("(src|href)=\"([^\"]{0,12})");
  for (auto it = std::sregex_iterator(page.begin(), page.end(), address);
       it != std::sregex_iterator(); ++it) {
    EXPECT_TRUE(it->str(2).starts_with("data:")) << it->str();
  }
}

class Html : public testing::Test {
 protected:
  void make_cloud(const std::string& options = "folded -n 20000") const {
    ASSERT_EQ(folder_.run("make-cloud " + options + " -o cloud.ply").exit_code, 0);
  }
  Outcome run(const std::string& options) const {
    return folder_.run("stream-recon cloud.ply " + options);
  }

  CommandFolder folder_;
};

TEST_F(Html, HoldsTheFiguresOfTheReportAndPictures) {
  make_cloud();
  for (const std::string output : {"out.pvtp", "out.ply", "out.vtk"}) {
    SCOPED_TRACE(output);
    const Outcome outcome = run("-o " + output + " --report run.json --html run.html");
    ASSERT_EQ(outcome.exit_code, 0) << outcome.error;
    const std::string page = folder_.bytes("run.html");
    expect_self_contained(page);
    const auto report = folder_.json("run.json");
    for (const std::uint64_t number :
         {report["input"]["points"], report["delaunay"]["tetrahedra"],
          report["surface"]["vertices"], report["surface"]["triangles"],
          report["surface"]["boundary_edges"]}) {
      EXPECT_THAT(page, HasSubstr(std::string(">").append(with_commas(number)).append("<")));
    }
    EXPECT_THAT(page, HasSubstr(report["surface"]["digest"].get<std::string>()));
    EXPECT_THAT(page, HasSubstr(report["delaunay"]["digest"].get<std::string>()));
    for (const auto& stage : report["stages"]) {
      EXPECT_THAT(page, HasSubstr(stage["name"].get<std::string>()));
    }
    EXPECT_THAT(page, HasSubstr("src=\"data:image/png;base64,iVBOR"));
  }
}

TEST_F(Html, ChangesNoOtherOutput) {
  make_cloud();
  ASSERT_EQ(run("-o a.pvtp --report a.json").exit_code, 0);
  ASSERT_EQ(run("-o b.pvtp --report b.json --html b.html").exit_code, 0);
  EXPECT_EQ(folder_.chunked_bytes("a", ".pvtp"), folder_.chunked_bytes("b", ".pvtp"));
  EXPECT_EQ(folder_.json("a.json")["surface"], folder_.json("b.json")["surface"]);
}

TEST_F(Html, TheReportCountsEachTriangleInItsDegree) {
  make_cloud();
  for (const std::string options :
       {"--surface gamma", "--surface gamma --delta-max 40", "--surface alpha --alpha 0.05"}) {
    SCOPED_TRACE(options);
    ASSERT_EQ(run(options + " -o out.vtk --report run.json").exit_code, 0);
    const auto surface = folder_.json("run.json")["surface"];
    std::uint64_t sum = 0;
    std::uint64_t beyond = 0;
    for (std::size_t degree = 0; degree < 180; ++degree) {
      const std::uint64_t count = surface["delta_histogram"].at(degree);
      sum += count;
      if (degree >= 40) beyond += count;
    }
    EXPECT_EQ(surface["delta_histogram"].size(), 180U);
    EXPECT_EQ(sum, surface["triangles"]);
    EXPECT_EQ(beyond == 0, options.ends_with("40"));
  }
}

TEST_F(Html, TheReportTellsMemoryOverTime) {
  make_cloud("folded -n 100000");
  ASSERT_EQ(run("-o out.pvtp --report run.json").exit_code, 0);
  const auto report = folder_.json("run.json");
  const auto& seconds = report["memory_over_time"]["seconds"];
  const auto& bytes = report["memory_over_time"]["resident_bytes"];
  ASSERT_EQ(seconds.size(), bytes.size());
  EXPECT_GE(seconds.size(), 4U);
  EXPECT_LE(seconds.size(), 512U);
  for (std::size_t i = 0; i < seconds.size(); ++i) {
    if (i > 0) {
      EXPECT_GE(seconds[i], seconds[i - 1]);
    }
    EXPECT_GT(bytes[i], 1 << 20);
    EXPECT_LE(bytes[i].get<double>(), 1.02 * report["peak_rss_bytes"].get<double>());
  }
  double last = 0;
  for (const auto& stage : report["stages"]) {
    EXPECT_GE(stage["start_seconds"].get<double>(), last - 1e-3);
    last = stage["start_seconds"].get<double>() + stage["seconds"].get<double>();
  }
  EXPECT_LE(last, report["seconds"].get<double>() + 1e-3);
}

TEST_F(Html, IsNotThereAfterAFailedRun) {
  put_bytes(folder_.path("cloud.ply"), "ply\nformat ascii 1.0\nelement vertex 9\n");
  EXPECT_EQ(run("-o out.pvtp --html run.html").exit_code, 65);
  make_cloud();
  EXPECT_EQ(run("-o out.pvtp --memory 1M --html run.html").exit_code, 69);
  EXPECT_EQ(run("-o out.pvtp --html missing/run.html").exit_code, 74);
  EXPECT_EQ(run("-o - --html - > /dev/null").exit_code, 64);
  EXPECT_EQ(run("-o out.pvtp --html same --report same").exit_code, 64);
  EXPECT_EQ(folder_.names(), std::vector<std::string>{"cloud.ply"});
}

TEST_F(Html, GoesWithoutPicturesWhereThereIsNothingToDraw) {
  make_cloud("cube -n 500");
  ASSERT_EQ(run("--surface none --tetrahedra t.pvtu --html none.html").exit_code, 0);
  EXPECT_THAT(folder_.bytes("none.html"), Not(HasSubstr("<img")));
  ASSERT_EQ(run("-o - --html pipe.html > out.ply").exit_code, 0);
  EXPECT_THAT(folder_.bytes("pipe.html"), Not(HasSubstr("<img")));
  ASSERT_EQ(run("--surface alpha --alpha 1e-9 -o empty.pvtp --html empty.html").exit_code, 0);
  EXPECT_THAT(folder_.bytes("empty.html"), Not(HasSubstr("<img")));
  EXPECT_THAT(folder_.bytes("empty.html"), HasSubstr("No pictures"));
}

TEST_F(Html, SaysThatAResumedRunHasTheTimesOfItsLastPart) {
  make_cloud("cube -n 500");
  ASSERT_EQ(run("-o out.pvtp --resume --html run.html").exit_code, 0);
  EXPECT_THAT(folder_.bytes("run.html"), HasSubstr("--resume"));
  EXPECT_THAT(folder_.bytes("run.html"), HasSubstr("last part"));
}

TEST_F(Html, PicturesStayWithinTheMemoryOfTheRun) {
  if (!kMemoryIsOurs) GTEST_SKIP() << "the sanitizer's memory is not the program's";
  make_cloud("folded -n 150000");
  for (const std::string options :
       {"-o out.pvtp --memory 64M", "-o out.ply --memory 64M", "-o out.vtk --memory 80M",
        "-o out.pvtp --chunk-points 1000000 --memory 80M"}) {
    SCOPED_TRACE(options);
    const Outcome outcome = folder_.run(
        "python3 -c 'import resource, subprocess, sys\n"
        "code = subprocess.call(sys.argv[1:])\n"
        "print(resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss)\n"
        "sys.exit(code)' stream-recon cloud.ply --html run.html --report run.json " +
        options);
    ASSERT_EQ(outcome.exit_code, 0) << outcome.error;
    EXPECT_LE(std::stoull(outcome.out) * 1024, folder_.json("run.json")["memory_budget_bytes"]);
  }
}

/// Runs Chromium without a window; what it says on standard error is in `error`.
class Browser : public Html {
 protected:
  void SetUp() override {
    if (folder_.run("command -v chromium").exit_code != 0) {
      GTEST_SKIP() << "no chromium here; install it to see the page as a browser does";
    }
    make_cloud();
    ASSERT_EQ(run("-o 'out <b>&.pvtp' --html run.html --report run.json").exit_code, 0);
  }

  Outcome browse(const std::string& options) const {
    return folder_.run(
        "timeout 60 chromium --headless --no-sandbox --disable-gpu --hide-scrollbars "
        "--enable-logging=stderr --user-data-dir=\"$PWD/profile\" " +
        options);
  }
};

TEST_F(Browser, ShowsTheFiguresAndComplainsOfNothing) {
  const Outcome outcome = browse("--dump-dom run.html");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.error;
  EXPECT_THAT(outcome.error, Not(HasSubstr("CONSOLE")));
  const auto report = folder_.json("run.json");
  EXPECT_THAT(outcome.out, HasSubstr(with_commas(report["surface"]["triangles"])));
  EXPECT_THAT(outcome.out, HasSubstr(report["surface"]["digest"].get<std::string>()));
  EXPECT_THAT(outcome.out, HasSubstr("out &lt;b&gt;&amp;.pvtp"));
  EXPECT_THAT(outcome.out, Not(HasSubstr("<b>&")));
}

TEST_F(Browser, WouldTellOfErrors) {
  put_bytes(folder_.path("bad.html"), "<script>missing_function();</script>");
  EXPECT_THAT(browse("--dump-dom bad.html").error, HasSubstr("CONSOLE"));
}

TEST_F(Browser, FillsThePageAtAnyWidth) {
  for (const unsigned width : {800U, 1400U}) {
    SCOPED_TRACE(width);
    const std::string name = std::to_string(width) + ".png";
    const Outcome outcome = browse("--window-size=" + std::to_string(width) +
                                   ",2000 --screenshot=\"$PWD/" + name + "\" run.html");
    ASSERT_EQ(outcome.exit_code, 0) << outcome.error;
    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    ASSERT_NE(png_image_begin_read_from_file(&image, folder_.path(name).c_str()), 0);
    EXPECT_EQ(image.width, width);
    EXPECT_EQ(image.height, 2000U);
    image.format = PNG_FORMAT_RGB;
    std::vector<std::uint8_t> bytes(PNG_IMAGE_SIZE(image));
    ASSERT_NE(png_image_finish_read(&image, nullptr, bytes.data(), 0, nullptr), 0);
    std::set<std::array<std::uint8_t, 3>> colors;
    std::size_t outside = 0;
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
      colors.insert({bytes[i], bytes[i + 1], bytes[i + 2]});
      const bool is_edge = i / 3 % width + 1 == width;  // nothing is cut off at the right
      if (is_edge && !std::equal(&bytes[i], &bytes[i] + 3, bytes.data())) ++outside;
    }
    EXPECT_GT(colors.size(), 1000U);
    EXPECT_EQ(outside, 0U);
  }
}

}  // namespace
}  // namespace stream_recon
