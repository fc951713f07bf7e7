// Small bodies on disk for the tests of pictures.
#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>
#include <string>
#include <vector>

#include "io/scratch_directory.h"
#include "io/surface_writer.h"
#include "tests/io_test_folder.h"
#include "tools/preview/preview.h"

namespace stream_recon {

struct Ball {
  Point3 center;
  double radius = 1;
  std::uint64_t first_id = 0;
  int rings = 24;
};

/// Triangles of a ball; Delta grows from 0 at its top to 90 at its bottom, Closure from 0 to 6.
inline SurfaceChunk ball_chunk(const Ball& ball) {
  SurfaceChunk chunk;
  const int columns = 2 * ball.rings;
  for (int j = 0; j <= ball.rings; ++j) {
    const double down = std::numbers::pi * j / ball.rings;
    for (int i = 0; i < columns; ++i) {
      const double around = 2 * std::numbers::pi * i / columns;
      chunk.global_ids.push_back(ball.first_id + chunk.points.size());
      chunk.vertex_numbers.push_back(chunk.global_ids.back());
      chunk.points.push_back({ball.center.x + ball.radius * std::sin(down) * std::cos(around),
                              ball.center.y + ball.radius * std::sin(down) * std::sin(around),
                              ball.center.z + ball.radius * std::cos(down)});
    }
  }
  const auto at = [columns](int j, int i) {
    return static_cast<std::uint32_t>(j * columns + i % columns);
  };
  for (int j = 0; j < ball.rings; ++j) {
    for (int i = 0; i < columns; ++i) {
      chunk.triangles.push_back({at(j, i), at(j + 1, i), at(j, i + 1)});
      chunk.triangles.push_back({at(j, i + 1), at(j + 1, i), at(j + 1, i + 1)});
      chunk.delta.insert(chunk.delta.end(), 2, static_cast<float>(90.0 * (j + 0.5) / ball.rings));
      chunk.closure.insert(chunk.closure.end(), 2, chunk.delta.back() / 15);
    }
  }
  chunk.source.resize(chunk.triangles.size(),
                      ball.first_id == 0 ? TriangleSource::kGamma : TriangleSource::kAlpha);
  return chunk;
}

/// A folder for one test's meshes, and pictures of them.
class ShapeFolder {
 public:
  std::string path(const std::string& name) const { return folder_ / name; }

  /// A mesh with a chunk for each ball; the points of one follow those of the other.
  std::string write(const std::string& name, std::vector<Ball> balls) const {
    const ScratchDirectory scratch({.parent = folder_.path()});
    const auto writer = make_surface_writer({.path = path(name),
                                             .scratch = const_cast<ScratchDirectory*>(&scratch),
                                             .has_closure = true});
    std::uint64_t ids = 0;
    for (std::size_t i = 0; i < balls.size(); ++i) {
      balls[i].first_id = ids;
      const SurfaceChunk chunk = ball_chunk(balls[i]);
      ids += chunk.points.size();
      writer->write(i, chunk);
    }
    writer->finish();
    return path(name);
  }

  /// The points alone, as text.
  std::string write_cloud(const std::string& name, const std::vector<Ball>& balls) const {
    std::string text;
    for (const Ball& ball : balls) {
      for (const Point3& p : ball_chunk(ball).points) {
        text += std::to_string(p.x) + " " + std::to_string(p.y) + " " + std::to_string(p.z) + "\n";
      }
    }
    put_bytes(path(name), text);
    return path(name);
  }

 private:
  TestFolder folder_;
};

inline PreviewOptions small_picture(const std::string& views = "front",
                                    const std::string& background = "white") {
  return {.width = 96,
          .height = 96,
          .views = parse_views(views),
          .background = parse_background(background)};
}

inline PreviewInput colored(const std::string& path, const std::string& color) {
  return {path, parse_coloring(color)};
}

}  // namespace stream_recon
