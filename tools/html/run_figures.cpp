#include "tools/html/run_figures.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "tools/html/text.h"

namespace stream_recon::html {
namespace {

/// A table of what is and how much, already escaped.
class Figures {
 public:
  Figures& add(const std::string& name, const std::string& value) {
    rows_ += fmt::format("<tr><th scope=\"row\">{}</th><td class=\"number\">{}</td></tr>\n", name,
                         value);
    return *this;
  }
  std::string section(const std::string& title) const {
    return fmt::format("<section><h2>{}</h2>\n<table><tbody>\n{}</tbody></table></section>\n",
                       title, rows_);
  }

 private:
  std::string rows_;
};

std::string pair(const std::string& left, const std::string& right) {
  return "<div class=\"pair\">\n" + left + right + "</div>\n";
}

std::string hash(const std::string& digest) {
  return "<span class=\"hash\">" + escape(digest) + "</span>";
}

std::string surface_figures(const Report& report) {
  const auto& surface = report.surface;
  Figures figures;
  figures.add("kind", escape(surface.kind))
      .add("vertices", count(surface.vertices))
      .add("samples without a triangle", count(surface.unused_samples))
      .add("triangles", count(surface.triangles))
      .add("boundary edges", count(surface.boundary_edges))
      .add("edges of 3 or more triangles", count(surface.nonmanifold_edges))
      .add("Euler characteristic", count(surface.euler))
      .add("components", count(surface.components));
  if (surface.kind == "solid") {
    figures.add("cavities", count(surface.cavities))
        .add("doubtful fills", count(surface.doubtful_fills));
  }
  if (surface.genus) figures.add("genus", count(*surface.genus));
  figures.add("area", fmt::format("{:.6g}", surface.area));
  if (surface.volume) figures.add("volume", fmt::format("{:.6g}", *surface.volume));
  return figures.add("digest", hash(surface.digest)).section("Surface");
}

std::string input_figures(const Report& report) {
  Figures figures;
  figures.add("points", count(report.input.points))
      .add("duplicates", count(report.input.duplicates))
      .add("not finite", count(report.input.rejected));
  if (const auto& spacing = report.input.spacing) {
    figures.add("spacing of the samples", fmt::format("{:.6g}", fmt::join(*spacing, " x ")));
  }
  return figures.add("Delaunay tetrahedra", count(report.delaunay.tetrahedra))
      .add("digest", hash(report.delaunay.digest))
      .section("Input and Delaunay structure");
}

/// Empty where the run needed no poles.
std::string pole_figures(const Report& report) {
  if (!report.poles) return "";
  const PoleReport& poles = *report.poles;
  return Figures()
      .add("balls", count(poles.count))
      .add("inside", count(poles.inner))
      .add("outside", count(poles.outer))
      .add("tetrahedra of a ball that others have", count(poles.coincident))
      .add("samples with a pole at infinity", count(poles.unbounded))
      .add("balls on both sides", count(poles.conflicts))
      .section("Poles");
}

/// Empty where none was asked for.
std::string shape_figures(const Report& report) {
  if (!report.shape) return "";
  const ShapeReport& shape = *report.shape;
  return Figures()
      .add("balls with a cell", count(shape.vertices))
      .add("edges", count(shape.edges))
      .add("edges without a triangle", count(shape.bare_edges))
      .add("triangles", count(shape.triangles))
      .add("tetrahedra", count(shape.tetrahedra))
      .add("Euler characteristic", count(shape.euler()))
      .section("Power shape");
}

/// Empty but for the hybrid.
std::string hybrid_figures(const Report& report) {
  if (!report.hybrid) return "";
  const HybridReport& hybrid = *report.hybrid;
  return Figures()
      .add("holes of the gamma shape", count(hybrid.holes))
      .add("closed by triangles", count(hybrid.by_triangles))
      .add("closed by the crust", count(hybrid.by_crust))
      .add("filled by the solid", count(hybrid.by_solid))
      .add("left open", count(hybrid.left_out))
      .add("triangles of patches", count(hybrid.patch_triangles))
      .section("Holes");
}

std::string window_figures(const Report& report) {
  const auto& windows = report.windows;
  return Figures()
      .add("windows", count(windows.count))
      .add("begun too large", count(windows.splits))
      .add("guests", count(windows.guests))
      .add("rounds", count(windows.rounds))
      .add("cells asked about", count(windows.queries))
      .add("nodes visited", count(windows.node_visits))
      .add("inserting, all threads", duration(windows.insert_seconds))
      .add("searching, all threads", duration(windows.search_seconds))
      .section("Windows");
}

std::string resource_figures(const Report& report) {
  return Figures()
      .add("time", duration(report.seconds))
      .add("threads", count(std::uint64_t{report.threads}))
      .add("memory allowed", bytes(report.memory_budget_bytes))
      .add("peak memory", bytes(report.peak_rss_bytes))
      .add("peak of the scratch files", bytes(report.scratch_peak_bytes))
      .section("Resources");
}

}  // namespace

bool has_surface(const Report& report) {
  return report.surface.kind != "none";
}

std::string run_figures(const Report& report) {
  if (!has_surface(report)) {
    return pair(input_figures(report), resource_figures(report)) + window_figures(report) +
           pole_figures(report) + shape_figures(report);
  }
  return pair(surface_figures(report), input_figures(report)) +
         pair(window_figures(report), resource_figures(report)) + pole_figures(report) +
         shape_figures(report) + hybrid_figures(report);
}

}  // namespace stream_recon::html
