// slices-to-points: points of the surfaces in a volume or a stack of slices.

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <spdlog/spdlog.h>

#include <string>

#include "tools/convert/command_line.h"
#include "tools/convert/conversion.h"

namespace {

using namespace stream_recon;

void convert(const ConverterCommand& line) {
  check(line);
  const auto volume = open_volume(volume_request(line));
  const SamplingOptions options = sampling_options(line, volume->geometry());
  const auto& size = volume->geometry().size;
  const std::string from =
      fmt::format("{} x {} x {} voxels of {}", size[0], size[1], size[2], volume->source());
  if (line.label == "each") {
    const LabelCounts counts = write_each_label(*volume, options, output_options(line));
    spdlog::info("{} labels, {} points, from {}", counts.labels, counts.points, from);
    if (!counts.smoothed_away.empty()) {
      spdlog::warn(
          "all voxels of these labels are smoothed away, they have no file: {}; add "
          "--keep-thin, or smooth less",
          fmt::join(counts.smoothed_away, ", "));
    }
    return;
  }
  const SampleCounts counts = write_points(*volume, options, output_options(line));
  const std::string what = description(options);
  if (line.iso) {
    spdlog::info("{} points: {}, from {}", counts.points, what, from);
  } else {
    const bool moved = counts.voxels_lost + counts.voxels_gained > 0;
    spdlog::info("{} points: {}, {} voxels{}, from {}", counts.points, what, counts.voxels,
                 moved ? fmt::format(" (smoothing took {} and added {})", counts.voxels_lost,
                                     counts.voxels_gained)
                       : "",
                 from);
  }
}

constexpr const char* kFooter =
    "Objects (--label, --above, --at-least) are closed at the volume's edge, and so at that of\n"
    "--roi; --iso is open there. By default an object's points lie on its smoothed boundary;\n"
    "how many voxels smoothing took from it, and added, is said.\n"
    "Memory is a few slices, however long the stack.";

}  // namespace

int main(int argc, char** argv) {
  ConverterCommand line;
  CLI::App app("Writes points of the surfaces in a volume or a stack of slices",
               "slices-to-points");
  app.footer(kFooter);
  add_converter_options(app, line);
  return run_tool(app, argc, argv, [&] { convert(line); });
}
