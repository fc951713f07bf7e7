#include "tools/preview/preview.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "tools/preview/depth_buffer.h"
#include "tools/preview/lettering.h"
#include "tools/preview/projection.h"
#include "tools/preview/scene.h"
#include "tools/preview/shading.h"

namespace stream_recon {
namespace {

constexpr std::size_t kMaxSide = 16384;
constexpr double kLeastText = 12;     // pixels
constexpr double kTextShare = 0.022;  // of the picture's height

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

/// One view of the scene, drawn part by part.
class Panel {
 public:
  Panel(const NamedView& view, const Box3& box, std::size_t width, std::size_t height)
      : view_(view),
        screen_(2 * width, 2 * height),
        project_(box, screen_),
        area_((box.high.x - box.low.x) * (box.high.y - box.low.y) * project_.scale() *
              project_.scale()) {}

  // A vertex has the mean normal of its triangles, weighted by area: triangles are not oriented, so
  // each first turns to the viewer.
  template <class PaintOf>
  void draw_triangles(const VtpMesh& mesh, const PaintOf& paint_of) {
    std::vector<ScreenVertex> vertices(mesh.points.size());
    for (std::size_t i = 0; i < vertices.size(); ++i) {
      vertices[i].position = project_(view_.view(mesh.points[i]));
    }
    for (const auto& [a, b, c] : mesh.triangles) {
      const Vector3f n =
          facing_normal(vertices[a].position, vertices[b].position, vertices[c].position);
      for (const std::uint32_t corner : {a, b, c}) add(vertices[corner].normal, n);
    }
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
      const auto& [a, b, c] = mesh.triangles[i];
      screen_.draw({vertices[a], vertices[b], vertices[c]}, paint_of(i));
    }
  }

  void draw_points(const std::vector<Point3>& points, float radius, Paint paint) {
    for (const Point3& point : points) {
      screen_.draw_disc(project_(view_.view(point)), radius, paint);
    }
  }

  /// Points on a ball are sqrt(pi) times as far apart as the box's share of each: discs that cover.
  float disc_radius(std::uint64_t points) const {
    constexpr double kLeast = 1.2;
    constexpr double kMost = 10;
    const double spacing = 1.45 * std::sqrt(area_ / static_cast<double>(points));
    return static_cast<float>(std::clamp(spacing, kLeast, kMost));
  }

  Picture shade(const ShadeOptions& options) const { return stream_recon::shade(screen_, options); }

 private:
  const NamedView& view_;
  DepthBuffer screen_;
  Projection project_;
  double area_;  ///< of the box on the screen, samples
};

/// The columns of a picture: views side by side, then the legend.
struct Layout {
  std::vector<LegendBlock> legend;
  double text_size = kLeastText;
  std::vector<std::size_t> panel_widths;
};

Layout lay_out(const Scene& scene, const PreviewOptions& options) {
  Layout layout;
  layout.text_size = std::max(kLeastText, kTextShare * static_cast<double>(options.height));
  if (options.has_legend) layout.legend = scene.legend();
  std::size_t legend = legend_width(layout.legend, layout.text_size);
  if (legend > options.width / 3) {
    layout.legend.clear();
    legend = 0;
  }
  const std::size_t panels = options.views.size();
  std::size_t left = options.width - legend;
  for (std::size_t i = 0; i < panels; ++i) {
    layout.panel_widths.push_back(left / (panels - i));
    left -= layout.panel_widths.back();
  }
  return layout;
}

void draw(Scene& scene, const PreviewOptions& options, std::vector<Panel>& panels) {
  for (std::size_t i = 0; i < scene.pieces().size(); ++i) {
    const Scene::Piece& piece = scene.pieces()[i];
    piece.parts->for_each([&](const VtpMesh& part) {
      for (Panel& panel : panels) {
        panel.draw_triangles(part, [&](std::size_t t) { return scene.paint(i, part, t); });
        if (!part.triangles.empty() || part.points.empty()) continue;
        const float radius = options.point_size > 0 ? static_cast<float>(options.point_size)
                                                    : panel.disc_radius(piece.loose_points);
        panel.draw_points(part.points, radius, scene.point_paint(i));
      }
    });
  }
}

void check(const std::vector<PreviewInput>& inputs, const PreviewOptions& options) {
  const auto in_range = [](std::size_t side) { return side >= 1 && side <= kMaxSide; };
  if (!in_range(options.width) || !in_range(options.height)) {
    throw std::invalid_argument("a picture's sides are 1 to 16384 pixels");
  }
  if (inputs.empty() || inputs.size() > kDistinctCount) {
    throw std::invalid_argument("a picture shows 1 to 1024 files");
  }
  if (options.views.empty() || options.views.size() > options.width / 2) {
    throw std::invalid_argument("too many views for the width; give a larger --size");
  }
}

/// Shades the panels one after the other and gives up each, so that one at a time is in memory
/// twice.
Picture assemble(std::vector<Panel>& panels, const Layout& layout, const Scene& scene,
                 const PreviewOptions& options) {
  Picture picture(options.width, options.height);
  const std::vector<Color> palette = scene.palette();
  std::size_t x = options.width;
  if (!layout.legend.empty()) {
    const Picture legend =
        draw_legend(layout.legend, options.height, {layout.text_size, options.background});
    x -= legend.width();
    picture.paste(legend, x);
  }
  for (std::size_t i = panels.size(); i-- > 0;) {
    x -= layout.panel_widths[i];
    Picture panel = panels[i].shade({palette, options.background});
    if (options.views.size() > 1) {
      write_text(
          panel, options.views[i].name,
          {layout.text_size, 1.8 * layout.text_size, layout.text_size, options.background.ink()});
    }
    picture.paste(panel, x);
    panels.pop_back();
  }
  return picture;
}

}  // namespace

Picture draw_preview(const std::vector<PreviewInput>& inputs, const PreviewOptions& options) {
  check(inputs, options);
  Scene scene(inputs, options.views);
  const Layout layout = lay_out(scene, options);
  std::vector<Panel> panels;
  panels.reserve(options.views.size());
  for (std::size_t i = 0; i < options.views.size(); ++i) {
    panels.emplace_back(options.views[i], scene.box(i), layout.panel_widths[i], options.height);
  }
  draw(scene, options, panels);
  return assemble(panels, layout, scene, options);
}

}  // namespace stream_recon
