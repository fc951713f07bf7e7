// mesh-preview: a shaded picture of a chunked mesh.

#include <spdlog/spdlog.h>

#include <sstream>
#include <stdexcept>

#include "tools/preview/preview.h"
#include "tools/run_tool.h"

namespace {

void parse_size(const std::string& text, stream_recon::PreviewOptions& options) {
  std::istringstream stream(text);
  char times = 0;
  stream >> options.width >> times >> options.height;
  if (!stream || times != 'x' || !(stream >> std::ws).eof())
    throw std::invalid_argument("the size '" + text + "' is not WIDTHxHEIGHT in pixels");
}

}  // namespace

int main(int argc, char** argv) {
  std::string mesh;
  std::string picture;
  std::string size = "1200x900";
  std::string view = "-35,20";
  CLI::App app("Draws a shaded picture of a mesh, chunk by chunk", "mesh-preview");
  app.add_option("mesh", mesh, "Chunked mesh (.pvtp) or one chunk (.vtp)")->required();
  app.add_option("-o,--output", picture, "PNG file, or - for standard output")->required();
  app.add_option("--size", size, "WIDTHxHEIGHT in pixels")->capture_default_str();
  app.add_option("--view", view,
                 "front, back, left, right, top, bottom, or AZIMUTH,ELEVATION in degrees")
      ->capture_default_str();
  return stream_recon::run_tool(app, argc, argv, [&] {
    stream_recon::PreviewOptions options;
    parse_size(size, options);
    options.view = stream_recon::parse_view(view);
    stream_recon::write_png(stream_recon::draw_preview(mesh, options), picture);
  });
}
