// mesh-preview: a shaded picture of meshes and point clouds.

#include <spdlog/spdlog.h>

#include <sstream>
#include <stdexcept>

#include "tools/preview/preview.h"
#include "tools/run_tool.h"

namespace {

using namespace stream_recon;

struct CommandLine {
  std::vector<std::string> inputs;
  std::vector<std::string> colors;
  std::string picture;
  std::string size = "1200x900";
  std::string view = "-35,20";
  std::string views;
  std::string background = "gradient";
  double point_size = 0;
  bool no_legend = false;
};

void add_options(CLI::App& app, CommandLine& line) {
  app.add_option("INPUT", line.inputs,
                 "Meshes (.pvtp, .vtp, binary .ply and .vtk) or point clouds of any kind that "
                 "stream-recon reads; all in one picture")
      ->required();
  app.add_option("-o,--output", line.picture, "PNG file, or - for standard output")->required();
  app.add_option("--size", line.size, "WIDTHxHEIGHT in pixels")->capture_default_str();
  auto* view = app.add_option(
      "--view", line.view,
      "front (seen along +y: x to the right, z up), back, left (from +x: the body's own left), "
      "right (from -x), top (from +z), bottom, or AZIMUTH,ELEVATION in degrees, from the front "
      "towards the body's left, then up");
  view->capture_default_str();
  app.add_option("--views", line.views, "Several, side by side: front,left,top")->excludes(view);
  app.add_option("--color", line.colors,
                 "What colours say: Delta, Source, Closure, component (of the surface), none, or "
                 "R,G,B; once "
                 "for all inputs or once for each (default: a colour for each input)")
      ->option_text("COLOR")
      ->expected(1)
      ->take_all();
  app.add_option("--background", line.background, "gradient, white, black, transparent, or R,G,B")
      ->capture_default_str();
  app.add_option("--point-size", line.point_size,
                 "Diameter of points without faces, pixels (default: as their density asks)")
      ->check(CLI::Range(0.5, 100.0))
      ->option_text("PIXELS");
  app.add_flag("--no-legend", line.no_legend, "Leave out what the colours mean");
}

void parse_size(const std::string& text, PreviewOptions& options) {
  std::istringstream stream(text);
  char times = 0;
  stream >> options.width >> times >> options.height;
  if (!stream || times != 'x' || !(stream >> std::ws).eof())
    throw std::invalid_argument("the size '" + text + "' is not WIDTHxHEIGHT in pixels");
}

std::vector<PreviewInput> parse_inputs(const CommandLine& line) {
  if (line.colors.size() > 1 && line.colors.size() != line.inputs.size()) {
    throw std::invalid_argument("give --color once, or once for each input");
  }
  std::vector<PreviewInput> inputs;
  for (std::size_t i = 0; i < line.inputs.size(); ++i) {
    PreviewInput& input = inputs.emplace_back();
    input.path = line.inputs[i];
    if (line.colors.empty()) continue;
    input.coloring = parse_coloring(line.colors[line.colors.size() == 1 ? 0 : i]);
  }
  return inputs;
}

void draw(const CommandLine& line) {
  PreviewOptions options;
  parse_size(line.size, options);
  if (line.views.empty()) {
    const View view = parse_view(line.view);
    options.views = {{line.view, view}};
  } else {
    options.views = parse_views(line.views);
  }
  options.background = parse_background(line.background);
  options.point_size = line.point_size;
  options.has_legend = !line.no_legend;
  write_png(draw_preview(parse_inputs(line), options), line.picture);
}

}  // namespace

int main(int argc, char** argv) {
  CommandLine line;
  CLI::App app("Draws a shaded picture of meshes and point clouds, part by part", "mesh-preview");
  add_options(app, line);
  return run_tool(app, argc, argv, [&] { draw(line); });
}
