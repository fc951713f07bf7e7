#include "tools/preview/preview.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

#include "io/error.h"
#include "io/pvtp_index.h"
#include "io/vtp_mesh_reader.h"
#include "spatial/box.h"
#include "tools/preview/depth_buffer.h"
#include "tools/preview/shading.h"

namespace stream_recon {
namespace {

constexpr std::size_t kMaxSide = 16384;
constexpr double kMargin = 0.06;  // of the screen's sides

std::vector<std::string> chunk_paths(const std::string& path) {
  if (path.ends_with(".vtp")) return {path};
  return read_pvtp_index(path);
}

/// The box of all drawn points in the view's coordinates.
Box3 bounds(const std::vector<std::string>& paths, const View& view) {
  Box3 box;
  for (const std::string& path : paths) {
    const VtpMesh mesh = read_vtp_mesh(path);
    for (const auto& triangle : mesh.triangles)
      for (const std::uint32_t corner : triangle) box.extend(view(mesh.points[corner]));
  }
  return box;
}

/// Where a point of the view's coordinates is on the screen.
class Projection {
 public:
  Projection(const Box3& box, const DepthBuffer& screen)
      : center_{middle(box.low.x, box.high.x), middle(box.low.y, box.high.y),
                middle(box.low.z, box.high.z)},
        half_width_(static_cast<double>(screen.width()) / 2),
        half_height_(static_cast<double>(screen.height()) / 2) {
    const double wide = std::max(box.high.x - box.low.x, box.extent() * 1e-6);
    const double high = std::max(box.high.y - box.low.y, box.extent() * 1e-6);
    scale_ = (1 - 2 * kMargin) * 2 * std::min(half_width_ / wide, half_height_ / high);
    if (!std::isfinite(scale_)) scale_ = 1;
  }

  Vector3f operator()(const Point3& p) const {
    return {static_cast<float>((p.x - center_.x) * scale_ + half_width_),
            static_cast<float>((p.y - center_.y) * scale_ + half_height_),
            static_cast<float>((p.z - center_.z) * scale_)};
  }

 private:
  static double middle(double low, double high) { return low / 2 + high / 2; }

  Point3 center_;
  double half_width_, half_height_;
  double scale_ = 1;
};

/// The normal of a triangle on the screen that faces the viewer, as long as twice its area.
Vector3f facing_normal(const Vector3f& a, const Vector3f& b, const Vector3f& c) {
  const Vector3f u{b.x - a.x, b.y - a.y, b.z - a.z};
  const Vector3f v{c.x - a.x, c.y - a.y, c.z - a.z};
  const Vector3f n{u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x};
  if (n.z < 0) return {-n.x, -n.y, -n.z};
  return n;
}

void add(Vector3f& sum, const Vector3f& n) {
  sum = {sum.x + n.x, sum.y + n.y, sum.z + n.z};
}

// A vertex has the mean normal of its triangles, weighted by area: triangles are not oriented, so
// each first turns to the viewer.
void draw_chunk(const VtpMesh& mesh, const View& view, const Projection& project,
                DepthBuffer& screen) {
  std::vector<ScreenVertex> vertices(mesh.points.size());
  for (std::size_t i = 0; i < vertices.size(); ++i)
    vertices[i].position = project(view(mesh.points[i]));
  for (const auto& [a, b, c] : mesh.triangles) {
    const Vector3f n =
        facing_normal(vertices[a].position, vertices[b].position, vertices[c].position);
    for (const std::uint32_t corner : {a, b, c}) add(vertices[corner].normal, n);
  }
  for (const auto& [a, b, c] : mesh.triangles) screen.draw({vertices[a], vertices[b], vertices[c]});
}

}  // namespace

Picture draw_preview(const std::string& path, const PreviewOptions& options) {
  const auto in_range = [](std::size_t side) { return side >= 1 && side <= kMaxSide; };
  if (!in_range(options.width) || !in_range(options.height))
    throw std::invalid_argument("a picture's sides are 1 to 16384 pixels");
  const std::vector<std::string> paths = chunk_paths(path);
  const Box3 box = bounds(paths, options.view);
  if (box.empty()) throw InputError(path + ": no triangles to draw; check how it was made");
  DepthBuffer screen(2 * options.width, 2 * options.height);
  const Projection project(box, screen);
  for (const std::string& chunk : paths)
    draw_chunk(read_vtp_mesh(chunk), options.view, project, screen);
  return shade(screen);
}

}  // namespace stream_recon
