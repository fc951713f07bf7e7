// A mesh gives the same picture from whatever file; a damaged file gives none.

#include <gtest/gtest.h>

#include <cstdlib>
#include <cstring>

#include "io/error.h"
#include "tests/preview_shapes.h"

namespace stream_recon {
namespace {

const std::vector<Ball> kBalls{{{0, 0, 0}, 2}, {{2.5, -1, 1}, 1}};

void expect_alike(const Picture& a, const Picture& b) {
  for (std::size_t y = 0; y < a.height(); ++y) {
    for (std::size_t x = 0; x < a.width(); ++x) {
      for (int c = 0; c < 3; ++c) {
        ASSERT_NEAR(a.at(x, y)[c], b.at(x, y)[c], 2) << x << ' ' << y;
      }
    }
  }
}

TEST(PreviewFormats, ShowTheSameMesh) {
  const ShapeFolder shapes;
  for (const std::string color : {"none", "component", "Delta", "Source"}) {
    SCOPED_TRACE(color);
    const auto draw = [&](const std::string& name) {
      return draw_preview({colored(shapes.write(name, kBalls), color)}, small_picture("20,10"));
    };
    const Picture chunked = draw("balls.pvtp");
    expect_alike(draw("balls.vtk"), chunked);
    if (color == "Delta" || color == "Source") continue;
    expect_alike(draw("balls.ply"), chunked);
  }
}

TEST(PreviewFormats, ReadPlyAsOthersWriteIt) {
  const ShapeFolder shapes;
  std::string bytes =
      "ply\nformat binary_big_endian 1.0\nelement vertex 4\nproperty uchar red\n"
      "property float x\nproperty float y\nproperty float z\nelement face 1\n"
      "property list uchar uint vertex_index\nproperty float quality\nend_header\n";
  const auto put = [&bytes](auto value) {
    char raw[sizeof value];
    std::memcpy(raw, &value, sizeof value);
    bytes.append(std::reverse_iterator(raw + sizeof value), std::reverse_iterator(raw));
  };
  const float square[4][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  for (const auto& [x, z] : square) {
    bytes += '\0';
    put(x);
    put(0.0F);
    put(z);
  }
  bytes += '\4';
  for (const std::uint32_t corner : {0U, 1U, 2U, 3U}) put(corner);
  put(1.0F);
  put_bytes(shapes.path("square.ply"), bytes);
  const Picture picture =
      draw_preview({{shapes.path("square.ply"), {}}}, small_picture("front", "transparent"));
  std::size_t covered = 0;
  for (std::size_t y = 0; y < 96; ++y) {
    for (std::size_t x = 0; x < 96; ++x) covered += picture.opacity(x, y) == 255 ? 1 : 0;
  }
  EXPECT_NEAR(static_cast<double>(covered), 84 * 84, 400);
}

TEST(PreviewFormats, DamageIsRefused) {
  const ShapeFolder shapes;
  for (const std::string name : {"balls.ply", "balls.vtk"}) {
    SCOPED_TRACE(name);
    const std::string path = shapes.write(name, kBalls);
    const std::string whole = file_bytes(path);
    const auto draw = [&](const std::string& bytes) {
      put_bytes(path, bytes);
      draw_preview({{path, {}}}, small_picture());
    };
    EXPECT_NO_THROW(draw(whole));
    EXPECT_THROW(draw(whole.substr(0, whole.size() / 2)), std::runtime_error);
    std::string wild = whole;
    const std::size_t corner = name == "balls.ply" ? whole.size() - 2 : whole.find("POLYGONS") + 40;
    wild[corner] = '\x7F';
    EXPECT_THROW(draw(wild), InputError);
  }
  put_bytes(shapes.path("text.ply"),
            "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
            "property float z\nelement face 1\nproperty list uchar int vertex_indices\n"
            "end_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
  EXPECT_THROW(draw_preview({{shapes.path("text.ply"), {}}}, small_picture()), InputError);
  EXPECT_THROW(draw_preview({{"-", {}}}, small_picture()), InputError);
  put_bytes(shapes.path("none.xyz"), "");
  EXPECT_THROW(draw_preview({{shapes.path("none.xyz"), {}}}, small_picture()), InputError);
}

}  // namespace
}  // namespace stream_recon
