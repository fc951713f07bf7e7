// What a picture shows: sides, nearness, colours, points, several files.

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>

#include "io/error.h"
#include "tests/preview_shapes.h"
#include "tests/process_memory_check.h"

namespace stream_recon {
namespace {

/// Pixels that are clearly of the hue of one of red, green, blue.
std::size_t count_hue(const Picture& picture, int hue) {
  std::size_t count = 0;
  for (std::size_t y = 0; y < picture.height(); ++y) {
    for (std::size_t x = 0; x < picture.width(); ++x) {
      const Rgb& color = picture.at(x, y);
      const int others = std::max(color[(hue + 1) % 3], color[(hue + 2) % 3]);
      count += color[hue] > others + 40 ? 1 : 0;
    }
  }
  return count;
}

constexpr int kRed = 0;
constexpr int kBlue = 2;

class PreviewScene : public testing::Test {
 protected:
  /// A red ball at one end of an axis and a blue one at the other.
  Picture draw_pair(const Point3& red, const Point3& blue, const std::string& view) const {
    const std::string first = shapes_.write("red.pvtp", {{.center = red}});
    const std::string second = shapes_.write("blue.pvtp", {{.center = blue}});
    return draw_preview({colored(first, "220,20,20"), colored(second, "20,20,220")},
                        small_picture(view));
  }

  ShapeFolder shapes_;
};

TEST_F(PreviewScene, EachSideShowsWhatIsThereAndHidesWhatIsBehind) {
  const struct {
    const char* view;
    Point3 near;
  } sides[] = {{"front", {0, -3, 0}}, {"back", {0, 3, 0}}, {"left", {3, 0, 0}},
               {"right", {-3, 0, 0}}, {"top", {0, 0, 3}},  {"bottom", {0, 0, -3}}};
  for (const auto& side : sides) {
    SCOPED_TRACE(side.view);
    const Point3 far{-side.near.x, -side.near.y, -side.near.z};
    const Picture picture = draw_pair(side.near, far, side.view);
    EXPECT_GT(count_hue(picture, kRed), 3000U);
    EXPECT_EQ(count_hue(picture, kBlue), 0U);
    EXPECT_GT(count_hue(draw_pair(far, side.near, side.view), kBlue), 3000U);
  }
}

TEST_F(PreviewScene, TheFrontHasXToTheRightAndZUp) {
  const Picture beside = draw_pair({3, 0, 0}, {-3, 0, 0}, "front");
  EXPECT_GT(beside.at(80, 48)[kRed], beside.at(80, 48)[kBlue] + 40);
  EXPECT_GT(beside.at(16, 48)[kBlue], beside.at(16, 48)[kRed] + 40);
  const Picture above = draw_pair({0, 0, 3}, {0, 0, -3}, "front");
  EXPECT_GT(above.at(48, 16)[kRed], above.at(48, 16)[kBlue] + 40);
  EXPECT_GT(above.at(48, 80)[kBlue], above.at(48, 80)[kRed] + 40);
}

TEST_F(PreviewScene, OppositeSidesAreMirrorImages) {
  const std::string path =
      shapes_.write("three.pvtp", {{{0, 0, 0}, 2}, {{3, 1, 1}, 1}, {{-2, 0.5, 3}, 0.5}});
  const std::array<std::array<const char*, 2>, 3> pairs{
      {{"front", "back"}, {"left", "right"}, {"-60,0", "120,0"}}};
  for (const auto& [one, other] : pairs) {
    SCOPED_TRACE(one);
    const Picture a = draw_preview({{path, {}}}, small_picture(one, "transparent"));
    const Picture b = draw_preview({{path, {}}}, small_picture(other, "transparent"));
    std::size_t different = 0;
    std::size_t covered = 0;
    for (std::size_t y = 0; y < 96; ++y) {
      for (std::size_t x = 0; x < 96; ++x) {
        const int difference = a.opacity(x, y) - b.opacity(95 - x, y);
        different += std::abs(difference) > 130 ? 1 : 0;
        covered += a.opacity(x, y) == 255 ? 1 : 0;
      }
    }
    EXPECT_LE(different, 6U);
    EXPECT_GT(covered, 1000U);
    EXPECT_LT(covered, 7000U);
  }
}

TEST_F(PreviewScene, ComponentsHaveColoursOfTheirOwnWhateverTheOrderOfTheirChunks) {
  const Ball large{{-3, 0, 0}, 1.5, 0, 32};
  const Ball middle{{0, 0, 0}, 1.5, 0, 24};
  const Ball little{{3, 0, 0}, 1.5, 0, 16};
  const std::string path = shapes_.write("a.pvtp", {large, middle, little});
  const std::string other = shapes_.write("b.pvtp", {little, large, middle});
  const Picture a = draw_preview({colored(path, "component")}, small_picture());
  const Picture b = draw_preview({colored(other, "component")}, small_picture());
  const std::array<Rgb, 3> seen{a.at(15, 44), a.at(46, 44), a.at(78, 44)};
  for (int i = 0; i < 3; ++i) {
    int contrast = 0;
    for (int c = 0; c < 3; ++c) contrast += std::abs(seen[i][c] - seen[(i + 1) % 3][c]);
    EXPECT_GT(contrast, 80) << i;
  }
  EXPECT_EQ(a.at(15, 44), b.at(15, 44));
  EXPECT_EQ(a.at(46, 44), b.at(46, 44));
  EXPECT_EQ(a.at(78, 44), b.at(78, 44));
}

TEST_F(PreviewScene, DeltaGoesFromDarkBlueToBrightYellow) {
  const std::string path = shapes_.write("ball.pvtp", {Ball{}});
  const Picture picture = draw_preview({colored(path, "Delta")}, small_picture());
  const Rgb& low = picture.at(48, 12);
  const Rgb& high = picture.at(48, 84);
  EXPECT_GT(low[kBlue], low[1]);
  EXPECT_LT(high[kBlue], high[1] * 2 / 3);
}

TEST_F(PreviewScene, ClosureHasTheColoursOfAScaleToo) {
  for (const char* name : {"ball.pvtp", "ball.vtk"}) {
    const std::string path = shapes_.write(name, {Ball{}});
    const Picture closure = draw_preview({colored(path, "Closure")}, small_picture());
    const Picture delta = draw_preview({colored(path, "Delta")}, small_picture());
    for (const auto& [x, y] : {std::pair(48, 12), std::pair(30, 48), std::pair(48, 84)}) {
      EXPECT_EQ(closure.at(x, y), delta.at(x, y)) << name;
    }
  }
}

TEST_F(PreviewScene, WhatIsNotThereCannotGiveColours) {
  const std::string mesh = shapes_.write("ball.ply", {Ball{}});
  const std::string cloud = shapes_.write_cloud("ball.xyz", {Ball{}});
  EXPECT_THROW(draw_preview({colored(mesh, "Delta")}, small_picture()), std::invalid_argument);
  EXPECT_THROW(draw_preview({colored(mesh, "Closure")}, small_picture()), std::invalid_argument);
  EXPECT_THROW(draw_preview({colored(mesh, "Source")}, small_picture()), std::invalid_argument);
  EXPECT_NO_THROW(draw_preview({colored(mesh, "component")}, small_picture()));
  EXPECT_THROW(draw_preview({colored(cloud, "component")}, small_picture()), std::invalid_argument);
  EXPECT_THROW(draw_preview({colored(cloud, "Delta")}, small_picture()), std::invalid_argument);
  EXPECT_THROW(draw_preview({}, small_picture()), std::invalid_argument);
}

TEST_F(PreviewScene, PointsFillTheirBodyAndAreShaded) {
  constexpr int kPoints = 5000;
  std::string text;
  for (int i = 0; i < kPoints; ++i) {
    const double z = 1 - (2 * i + 1.0) / kPoints;  // a spiral, evenly spaced
    const double across = std::sqrt(1 - z * z);
    text += std::to_string(across * std::cos(2.39996323 * i)) + " " +
            std::to_string(across * std::sin(2.39996323 * i)) + " " + std::to_string(z) + "\n";
  }
  const std::string cloud = shapes_.path("ball.xyz");
  put_bytes(cloud, text);
  const Picture picture = draw_preview({{cloud, {}}}, small_picture("front", "transparent"));
  std::size_t holes = 0;
  for (std::size_t y = 0; y < 96; ++y) {
    for (std::size_t x = 0; x < 96; ++x) {
      const double r = std::hypot(static_cast<double>(x) - 47.5, static_cast<double>(y) - 47.5);
      if (r < 40) holes += picture.opacity(x, y) < 255 ? 1 : 0;
      if (r > 46) {
        EXPECT_EQ(picture.opacity(x, y), 0) << x << ' ' << y;
      }
    }
  }
  EXPECT_EQ(holes, 0U);
  EXPECT_GT(picture.at(34, 30)[0], picture.at(66, 70)[0] + 40);
}

TEST_F(PreviewScene, PointsAreAsLargeAsAsked) {
  put_bytes(shapes_.path("two.xyz"), "0 0 0\n10 0 10\n");
  PreviewOptions options = small_picture("front", "transparent");
  const auto covered = [&] {
    const Picture picture = draw_preview({{shapes_.path("two.xyz"), {}}}, options);
    double sum = 0;
    for (std::size_t y = 0; y < 96; ++y) {
      for (std::size_t x = 0; x < 96; ++x) sum += picture.opacity(x, y) / 255.0;
    }
    return sum;
  };
  options.point_size = 4;
  EXPECT_NEAR(covered(), 2 * std::numbers::pi * 4, 6);
  options.point_size = 9;
  EXPECT_NEAR(covered(), 2 * std::numbers::pi * 4.5 * 4.5, 12);
}

TEST_F(PreviewScene, ViewsStandSideBySide) {
  const std::string path = shapes_.write("pair.pvtp", {{{0, 0, 0}, 2}, {{0, -4, 0}, 1}});
  PreviewOptions options = small_picture("front,top", "transparent");
  options.width = 192;
  const Picture both = draw_preview({{path, {}}}, options);
  const Picture top = draw_preview({{path, {}}}, small_picture("top", "transparent"));
  for (std::size_t y = 28; y < 96; ++y) {
    for (std::size_t x = 0; x < 96; ++x) {
      EXPECT_EQ(both.at(96 + x, y), top.at(x, y)) << x << ' ' << y;
    }
  }
}

TEST_F(PreviewScene, ALegendTakesAColumnWhereThereIsRoom) {
  const std::string path = shapes_.write("ball.pvtp", {Ball{}});
  PreviewOptions options = small_picture();
  options.width = 400;
  options.height = 240;
  const auto darkest_at_the_right = [&] {
    const Picture picture = draw_preview({colored(path, "Delta")}, options);
    int darkest = 255;
    for (std::size_t y = 0; y < picture.height(); ++y) {
      for (std::size_t x = picture.width() - 80; x < picture.width(); ++x) {
        darkest = std::min<int>(darkest, picture.at(x, y)[1]);
      }
    }
    return darkest;
  };
  EXPECT_LT(darkest_at_the_right(), 100);
  options.has_legend = false;
  EXPECT_EQ(darkest_at_the_right(), 255);
  options.has_legend = true;
  options.width = 120;
  options.height = 40;
  EXPECT_EQ(darkest_at_the_right() < 255, true);  // the ball itself: no room for words
}

TEST_F(PreviewScene, BackgroundsAreWhatTheySay) {
  const std::string path = shapes_.write("ball.pvtp", {Ball{}});
  const auto corner = [&](const char* background) {
    const Picture picture = draw_preview({{path, {}}}, small_picture("front", background));
    EXPECT_EQ(picture.opacity(48, 48), 255) << background;
    return std::pair(picture.at(0, 0), picture.opacity(0, 0));
  };
  EXPECT_EQ(corner("white"), std::pair(Rgb({255, 255, 255}), std::uint8_t{255}));
  EXPECT_EQ(corner("black"), std::pair(Rgb({0, 0, 0}), std::uint8_t{255}));
  EXPECT_EQ(corner("12,34,56"), std::pair(Rgb({12, 34, 56}), std::uint8_t{255}));
  EXPECT_EQ(corner("transparent").second, 0);
  EXPECT_THROW(parse_background("pink"), std::invalid_argument);
}

/// A rough field in strips, so that each chunk shares points with the next.
void write_field(const SurfaceWriterOptions& options, std::uint32_t strips, std::uint32_t rows) {
  constexpr std::uint32_t kColumns = 1000;
  const auto writer = make_surface_writer(options);
  for (std::uint32_t strip = 0; strip < strips; ++strip) {
    SurfaceChunk chunk;
    for (std::uint32_t row = strip * rows; row <= (strip + 1) * rows; ++row) {
      for (std::uint32_t column = 0; column < kColumns; ++column) {
        chunk.global_ids.push_back(std::uint64_t{row} * kColumns + column);
        chunk.vertex_numbers.push_back(chunk.global_ids.back());
        chunk.points.push_back({column / 10.0, row / 10.0, std::sin(column / 40.0) * 5});
      }
    }
    for (std::uint32_t i = 0; i + kColumns < chunk.points.size(); ++i) {
      if (i % kColumns == kColumns - 1) continue;
      chunk.triangles.push_back({i, i + 1, i + kColumns});
      chunk.triangles.push_back({i + 1, i + kColumns + 1, i + kColumns});
    }
    chunk.delta.resize(chunk.triangles.size(), 30);
    chunk.source.resize(chunk.triangles.size(), TriangleSource::kGamma);
    writer->write(strip, chunk);
  }
  writer->finish();
}

/// The peak of the resident set of a program's run, bytes.
std::uint64_t peak_of(const std::vector<std::string>& command) {
  const pid_t child = fork();
  if (child == 0) {
    std::vector<char*> words;
    for (const std::string& word : command) words.push_back(const_cast<char*>(word.c_str()));
    words.push_back(nullptr);
    execv(words[0], words.data());
    _exit(127);
  }
  int status = 0;
  rusage usage{};
  wait4(child, &status, 0, &usage);
  EXPECT_EQ(WIFEXITED(status) ? WEXITSTATUS(status) : -1, 0);
  return static_cast<std::uint64_t>(usage.ru_maxrss) * 1024;
}

TEST_F(PreviewScene, AMeshOfTwoMillionTrianglesNeedsTheMemoryOfThePicture) {
  if (!kMemoryIsOurs) GTEST_SKIP() << "the sanitizer's memory is not the program's";
  const std::string program = STREAM_RECON_BIN "/mesh-preview";
  for (const std::string name : {"field.pvtp", "field.ply", "field.vtk"}) {
    SCOPED_TRACE(name);
    {
      ScratchDirectory scratch({.parent = shapes_.path("")});
      write_field({.path = shapes_.path(name), .scratch = &scratch}, 40, 25);
    }
    const std::vector<std::string> command{program, shapes_.path(name),       "--size", "200x150",
                                           "-o",    shapes_.path("field.png")};
    EXPECT_LT(peak_of(command), std::uint64_t{40} << 20);
    std::vector<std::string> components = command;
    components.insert(components.end(), {"--color", "component"});
    EXPECT_LT(peak_of(components), std::uint64_t{46} << 20);
  }
}

}  // namespace
}  // namespace stream_recon
