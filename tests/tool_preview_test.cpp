#include "tools/preview/preview.h"

#include <gtest/gtest.h>
#include <png.h>

#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

#include "io/error.h"
#include "io/surface_writer.h"
#include "tests/io_test_folder.h"

namespace stream_recon {
namespace {

constexpr int kRings = 60;

// The part of a sphere of radius 2 between two angles around the z axis, kRings quads high.
SurfaceChunk sphere_wedge(double first, double last, int columns) {
  SurfaceChunk chunk;
  for (int i = 0; i <= columns; ++i) {
    const double around = first + (last - first) * i / columns;
    for (int j = 0; j <= kRings; ++j) {
      const double down = std::numbers::pi * j / kRings;
      chunk.vertex_numbers.push_back(chunk.points.size());
      chunk.global_ids.push_back(chunk.points.size());
      chunk.points.push_back({2 * std::sin(down) * std::cos(around),
                              2 * std::sin(down) * std::sin(around), 2 * std::cos(down)});
    }
  }
  const auto at = [](int i, int j) { return static_cast<std::uint32_t>(i * (kRings + 1) + j); };
  for (int i = 0; i < columns; ++i)
    for (int j = 0; j < kRings; ++j) {
      chunk.triangles.push_back({at(i, j), at(i + 1, j), at(i, j + 1)});
      chunk.triangles.push_back({at(i, j + 1), at(i + 1, j), at(i + 1, j + 1)});
    }
  chunk.delta.resize(chunk.triangles.size(), 10);
  chunk.source.resize(chunk.triangles.size(), TriangleSource::kGamma);
  return chunk;
}

class Preview : public testing::Test {
 protected:
  /// A sphere in a number of chunks.
  std::string write_sphere(int chunks) const {
    const std::string path = folder_ / ("sphere" + std::to_string(chunks) + ".pvtp");
    const auto writer = make_surface_writer({.path = path});
    const double wedge = 2 * std::numbers::pi / chunks;
    for (int i = 0; i < chunks; ++i)
      writer->write(i, sphere_wedge(i * wedge, (i + 1) * wedge, 120 / chunks));
    writer->finish();
    return path;
  }

  static Picture draw(const std::string& path, const char* view = "front") {
    return draw_preview({{path, {}}}, {.width = 160, .height = 120, .views = parse_views(view)});
  }

  TestFolder folder_;
};

int brightness(const Rgb& color) {
  return color[0] + color[1] + color[2];
}

/// Surfaces are warm, the background is not.
bool is_surface(const Rgb& color) {
  return color[0] > color[2] + 6;
}

TEST_F(Preview, ASphereFillsItsDiscAndIsLitFromTheUpperLeft) {
  const Picture picture = draw(write_sphere(1));
  std::size_t inside = 0;
  for (std::size_t y = 0; y < picture.height(); ++y)
    for (std::size_t x = 0; x < picture.width(); ++x) {
      const double r = std::hypot(static_cast<double>(x) - 79.5, static_cast<double>(y) - 59.5);
      if (r < 50) inside += is_surface(picture.at(x, y)) ? 1 : 0;
      EXPECT_FALSE(r > 56 && is_surface(picture.at(x, y))) << x << ' ' << y;
    }
  EXPECT_NEAR(static_cast<double>(inside), std::numbers::pi * 50 * 50, 300);
  EXPECT_GT(brightness(picture.at(60, 40)), brightness(picture.at(100, 80)) + 90);
  EXPECT_GT(brightness(picture.at(2, 2)), brightness(picture.at(2, 117)) + 20);
}

TEST_F(Preview, ChunksMakeNoSeams) {
  const Picture whole = draw(write_sphere(1));
  const Picture parts = draw(write_sphere(12));
  for (std::size_t y = 0; y < whole.height(); ++y)
    for (std::size_t x = 0; x < whole.width(); ++x)
      for (int c = 0; c < 3; ++c)
        EXPECT_NEAR(whole.at(x, y)[c], parts.at(x, y)[c], 24) << x << ' ' << y;
}

TEST_F(Preview, ThePictureIsTheOneWeKnow) {
  const Picture picture = draw(write_sphere(1));
  const struct {
    std::size_t x, y;
    Rgb color;
  } known[] = {
      {2, 2, {245, 247, 249}},   {157, 117, {208, 213, 220}}, {79, 59, {220, 189, 169}},
      {55, 35, {255, 218, 192}}, {105, 80, {126, 113, 108}},  {79, 20, {250, 215, 190}},
      {40, 60, {221, 188, 163}}, {79, 105, {60, 55, 54}},
  };
  for (const auto& pixel : known)
    for (int c = 0; c < 3; ++c)
      EXPECT_NEAR(picture.at(pixel.x, pixel.y)[c], pixel.color[c], 4)
          << pixel.x << ' ' << pixel.y << ' ' << c;
}

TEST_F(Preview, TheSamePictureEveryTime) {
  const std::string path = write_sphere(4);
  write_png(draw(path, "-30,20"), folder_ / "a.png");
  write_png(draw(path, "-30,20"), folder_ / "b.png");
  EXPECT_EQ(file_bytes(folder_ / "a.png"), file_bytes(folder_ / "b.png"));
}

TEST_F(Preview, PngKeepsEveryPixel) {
  Picture picture(7, 3);
  for (std::size_t y = 0; y < 3; ++y)
    for (std::size_t x = 0; x < 7; ++x)
      picture.at(x, y) = {std::uint8_t(x * 30), std::uint8_t(y * 100), std::uint8_t(255 - x - y)};
  write_png(picture, folder_ / "small.png");

  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  ASSERT_NE(png_image_begin_read_from_file(&image, (folder_ / "small.png").c_str()), 0);
  EXPECT_EQ(image.width, 7U);
  EXPECT_EQ(image.height, 3U);
  image.format = PNG_FORMAT_RGB;
  std::vector<std::uint8_t> bytes(PNG_IMAGE_SIZE(image));
  ASSERT_NE(png_image_finish_read(&image, nullptr, bytes.data(), 0, nullptr), 0);
  for (std::size_t i = 0; i < bytes.size(); ++i)
    EXPECT_EQ(bytes[i], picture.at(i / 3 % 7, i / 21)[i % 3]);
}

TEST_F(Preview, WhatCannotBeDrawnIsRefused) {
  const std::string empty = folder_ / "empty.pvtp";
  const auto writer = make_surface_writer({.path = empty});
  writer->finish();
  EXPECT_THROW(draw(empty), InputError);
  EXPECT_THROW(draw(folder_ / "missing.pvtp"), IoError);
  const std::string path = write_sphere(2);
  EXPECT_THROW(draw_preview({{path, {}}}, {.width = 0, .height = 100}), std::invalid_argument);
  EXPECT_THROW(draw_preview({{path, {}}}, {.width = 100, .height = 20000}), std::invalid_argument);
  std::filesystem::remove(folder_ / "sphere2/chunk_000001.vtp");
  EXPECT_THROW(draw(path), IoError);
}

}  // namespace
}  // namespace stream_recon
