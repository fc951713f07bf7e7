// Pictures against those in tests/pictures, which somebody has looked at. To replace them after a
// change of the looks: STREAM_RECON_NEW_PICTURES=1 tool_preview_test, and look at them.

#include <gtest/gtest.h>
#include <png.h>

#include <cstdlib>

#include "tests/preview_shapes.h"

namespace stream_recon {
namespace {

const std::vector<Ball> kBalls{{{0, 0, 0}, 2}, {{2.4, -1.2, 1}, 1}, {{-1, -2.4, -1}, 0.6}};

std::vector<std::uint8_t> read_rgb(const std::string& path) {
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  if (png_image_begin_read_from_file(&image, path.c_str()) == 0) return {};
  image.format = PNG_FORMAT_RGB;
  std::vector<std::uint8_t> bytes(PNG_IMAGE_SIZE(image));
  png_image_finish_read(&image, nullptr, bytes.data(), 0, nullptr);
  return bytes;
}

/// Alike but for single steps of colour, and for a few pixels at edges.
void expect_known(const Picture& picture, const std::string& name) {
  const std::string path = std::string(STREAM_RECON_PICTURES) + "/" + name;
  if (std::getenv("STREAM_RECON_NEW_PICTURES") != nullptr) write_png(picture, path);
  const std::vector<std::uint8_t> known = read_rgb(path);
  ASSERT_EQ(known.size(), 3 * picture.width() * picture.height()) << path;
  std::size_t far = 0;
  std::size_t sum = 0;
  for (std::size_t i = 0; i < known.size(); ++i) {
    const std::size_t pixel = i / 3;
    const int value = picture.at(pixel % picture.width(), pixel / picture.width())[i % 3];
    const int difference = std::abs(value - known[i]);
    sum += static_cast<std::size_t>(difference);
    far += difference > 24 ? 1 : 0;
  }
  EXPECT_LT(sum, known.size()) << name;
  EXPECT_LT(far, known.size() / 200) << name;
}

TEST(PreviewReference, AMeshInOneColour) {
  const ShapeFolder shapes;
  expect_known(
      draw_preview({{shapes.write("balls.pvtp", kBalls), {}}}, small_picture("-35,20", "gradient")),
      "plain.png");
}

TEST(PreviewReference, Components) {
  const ShapeFolder shapes;
  expect_known(draw_preview({colored(shapes.write("balls.pvtp", kBalls), "component")},
                            small_picture("left")),
               "components.png");
}

TEST(PreviewReference, DeltaWithItsLegendFromTwoSides) {
  const ShapeFolder shapes;
  PreviewOptions options = small_picture("front,top");
  options.width = 340;
  options.height = 120;
  expect_known(draw_preview({colored(shapes.write("balls.pvtp", kBalls), "Delta")}, options),
               "delta.png");
}

TEST(PreviewReference, PointsBesideAMesh) {
  const ShapeFolder shapes;
  const std::string cloud = shapes.write_cloud("cloud.xyz", {{{-2, 0, 0}, 1.5}});
  const std::string mesh = shapes.write("ball.pvtp", {{{1.5, 0, 0}, 1.5}});
  PreviewOptions options = small_picture("10,30", "gradient");
  options.width = 160;
  expect_known(draw_preview({{cloud, {}}, {mesh, {}}}, options), "points.png");
}

}  // namespace
}  // namespace stream_recon
