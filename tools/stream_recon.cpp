// stream-recon: surfaces from huge point clouds. See README.md for the options.

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <array>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "engine/reconstruct.h"
#include "engine/size_text.h"
#include "io/atomic_output.h"
#include "tools/html/run_page.h"
#include "tools/run_tool.h"

namespace {

using namespace stream_recon;

enum ExitCode { kDone = 0, kNoMemory = 69, kResumable = 75, kInterrupted = 130 };

/// What the command line says, beside what the engine takes as it is.
struct CommandLine {
  RunOptions run;
  std::string surface = "solid";
  std::string report;
  std::string html;
  std::vector<std::string> words;  ///< all of them, as typed
};

void add_input_options(CLI::App& app, CommandLine& line) {
  std::map<std::string, InputFormat> formats;
  for (const char* name : kInputFormatNames) {
    formats.emplace(name, static_cast<InputFormat>(formats.size()));
  }
  app.add_option("INPUT", line.run.inputs,
                 "Point files (.ply, .xyz, .txt, .f32, .f64, .pts, .vtk, .vtp), read one after the "
                 "other; - is standard input")
      ->required();
  app.add_option("--input-format", line.run.input_format,
                 "auto, ply, xyz, f32, f64, vtk, vtp or pts (default: auto)")
      ->transform(CLI::CheckedTransformer(formats))
      ->option_text("FORMAT");
}

/// One length, or three with commas between.
void add_spacing(CLI::App& app, std::optional<std::array<double, 3>>& spacing) {
  const auto read = [&spacing](const CLI::results_t& texts) {
    const std::vector<std::string> words = CLI::detail::split(texts.at(0), ',');
    std::array<double, 3> lengths{};
    if (words.size() != 1 && words.size() != 3) return false;
    for (std::size_t i = 0; i < lengths.size(); ++i) {
      if (!CLI::detail::lexical_cast(words[i % words.size()], lengths[i])) return false;
    }
    spacing = lengths;
    return true;
  };
  app.add_option("--spacing", read,
                 "solid, crust, hybrid: of the grid the points were sampled on, SX,SY,SZ or one "
                 "number, units "
                 "of the input (default: what the input says)")
      ->option_text("S");
}

void add_medial_axis_options(CLI::App& app, RunOptions& run) {
  std::map<std::string, PoleSide> sides;
  for (const char* name : kPoleSideNames) {
    sides.emplace(name, static_cast<PoleSide>(sides.size()));
  }
  app.add_option("--medial-axis", run.medial_axis,
                 "solid, crust, hybrid, none: also the medial axis, balls that touch the samples "
                 "from within: "
                 "OUT.pvtp with a folder of chunks")
      ->option_text("OUT");
  app.add_option(
         "--pole-tolerance", run.pole_tolerance,
         "crust, hybrid, medial axis: balls that differ by less than about this length become one "
         "(default: 0, only the very same)")
      ->option_text("LENGTH");
  app.add_option(
         "--least-ball", run.least_ball,
         "crust, hybrid, medial axis: leave out balls of fewer spacings of the samples than "
         "this, for noisy ones 1 (default: 0, all are there)")
      ->option_text("RATIO");
  app.add_option("--medial-axis-side", run.medial_axis_side,
                 "Which balls: inner (default), outer or both")
      ->transform(CLI::CheckedTransformer(sides))
      ->option_text("SIDE");
  app.add_flag(
      "--medial-axis-faces", run.medial_axis_faces,
      "crust, none: the medial axis has the triangles and edges between balls as well, the "
      "power shape");
}

void add_surface_options(CLI::App& app, CommandLine& line) {
  app.add_option(
         "-o,--output", line.run.output,
         "OUT.pvtp with a folder of chunks, OUT.ply or OUT.vtk, or - for PLY on standard output")
      ->option_text("OUT");
  app.add_option("--surface", line.surface, "solid (default), hybrid, crust, gamma, alpha or none")
      ->check(CLI::IsMember({"gamma", "alpha", "none", "crust", "hybrid", "solid"}))
      ->option_text("KIND");
  app.add_option("--delta-max", line.run.delta_max_degrees,
                 "gamma: take facets whose balls meet below this angle (default: 90)")
      ->option_text("DEG");
  app.add_option("--alpha", line.run.alpha, "alpha: radius of the ball, units of the input")
      ->option_text("R");
  app.add_option(
         "--open", line.run.open_ratio,
         "solid: leave facets beyond the gamma shape out where their circumradius is more "
         "than this many spacings of the samples (default: all are there, a closed surface)")
      ->option_text("RATIO");
  app.add_option("--fill", line.run.fills_with_solid,
                 "hybrid: what holes get that no patch closes: none (default) or solid, the "
                 "triangles of that surface")
      ->transform(
          CLI::CheckedTransformer(std::map<std::string, bool>{{"none", false}, {"solid", true}}))
      ->option_text("WITH");
  app.add_flag(
      "--manifold", line.run.manifold,
      "solid, crust: split the surface where it touches itself, so that every edge has two "
      "triangles and every vertex one fan of them");
  add_spacing(app, line.run.grid_spacing);
  app.add_option("--unused", line.run.unused,
                 "All but crust, hybrid: also the points that no triangle has, in OUT.ply")
      ->option_text("OUT");
  app.add_option("--tetrahedra", line.run.tetrahedra,
                 "Also the Delaunay tetrahedra: OUT.pvtu with a folder of chunks")
      ->option_text("OUT");
  add_medial_axis_options(app, line.run);
}

/// An option whose value is a size in bytes.
void add_size(CLI::App& app, const std::string& name, std::uint64_t& value,
              const std::string& description) {
  const auto read = [&value](const CLI::results_t& texts) {
    const auto size = parse_size(texts.at(0));
    value = size.value_or(0);
    return size.has_value();
  };
  app.add_option(name, read, description)->option_text("SIZE");
}

void add_resource_options(CLI::App& app, CommandLine& line) {
  add_size(
      app, "--memory", line.run.memory_bytes,
      "Peak resident memory of the process, e.g. 512M or 1.5G (default: half of the machine's)");
  app.add_option("--threads", line.run.threads, "Threads (default: all of the machine)")
      ->check(CLI::Range(1U, 4096U))
      ->option_text("N");
  app.add_option("--scratch", line.run.scratch,
                 "Folder for temporary files (default: beside the output)")
      ->option_text("DIR");
  add_size(app, "--scratch-limit", line.run.scratch_limit_bytes,
           "Disk that temporary files may take (default: no limit)");
  app.add_option("--chunk-points", line.run.chunk_points,
                 "Points that share a chunk of the output (default: 100000)")
      ->check(CLI::Range(std::uint64_t{1}, std::uint64_t{1} << 40))
      ->option_text("N");
  app.add_flag(
      "--resume", line.run.resume,
      "Go on after a kill, an error or Ctrl-C, to the same bytes; the same command otherwise");
}

void add_report_options(CLI::App& app, CommandLine& line) {
  const std::map<std::string, ProgressStyle> styles{{"auto", ProgressStyle::kAuto},
                                                    {"bar", ProgressStyle::kBar},
                                                    {"json", ProgressStyle::kJson},
                                                    {"none", ProgressStyle::kNone}};
  line.run.progress = ProgressStyle::kAuto;
  app.add_option("--report", line.report, "Counts, digests, memory and times, as JSON")
      ->option_text("FILE");
  app.add_option("--html", line.html,
                 "The report as a page to read: figures, charts, pictures; one file, no script")
      ->option_text("FILE");
  app.add_option("--progress", line.run.progress,
                 "auto (default: a bar on a terminal), bar, json or none; on standard error")
      ->transform(CLI::CheckedTransformer(styles))
      ->option_text("STYLE");
}

void check_combinations(const CLI::App& app, const CommandLine& line) {
  const auto require = [](bool holds, const char* message) {
    if (!holds) throw std::invalid_argument(message);
  };
  require(line.surface == "alpha" || app.count("--alpha") == 0,
          "--alpha is for --surface alpha; add that or leave --alpha out");
  require(line.surface == "gamma" || app.count("--delta-max") == 0,
          "--delta-max is for --surface gamma; leave it out");
  const bool has_axis = !line.run.medial_axis.empty();
  const bool needs_power = line.surface == "crust" || line.surface == "hybrid";
  require(line.surface == "hybrid" || app.count("--fill") == 0,
          "--fill is for --surface hybrid; add that or leave --fill out");
  for (const char* option : {"--open", "--spacing"}) {
    const bool has_labels = has_axis || needs_power;
    const bool is_theirs = has_labels && std::string_view(option) == "--spacing";
    if (line.surface != "solid" && !is_theirs && app.count(option) != 0) {
      throw std::invalid_argument(
          fmt::format("{0} is for --surface solid; add that or leave {0} out", option));
    }
  }
  require(
      has_axis || needs_power || app.count("--pole-tolerance") == 0,
      "--pole-tolerance is for --surface crust, hybrid and --medial-axis; add one or leave it out");
  require(has_axis || needs_power || app.count("--least-ball") == 0,
          "--least-ball is for --surface crust, hybrid and --medial-axis; add one or leave it out");
  require(has_axis || app.count("--medial-axis-side") == 0,
          "--medial-axis-side is for --medial-axis; add that or leave --medial-axis-side out");
  require(
      line.run.unused.empty() || (line.run.unused != line.report && line.run.unused != line.html),
      "--unused names the file of --report or --html; give it another name");
  require(line.run.output != "-" || line.report != "-",
          "-o - and --report - both want standard output; give one of them a file");
  require(line.html != "-" || (line.run.output != "-" && line.report != "-"),
          "--html - wants standard output for itself; give the page a file");
  require(line.html.empty() || line.html == "-" || line.html != line.report,
          "--html and --report name the same file; give one of them another name");
}

/// Finds out before the work whether the page can be written.
void try_html(const std::string& path) {
  if (!path.empty() && path != "-") const AtomicOutput probe(path);
}

void write_html(const CommandLine& line, const Report& report) {
  html::RunPage page{.report = report,
                     .inputs = line.run.inputs,
                     .outputs = {},
                     .command = line.words,
                     .note = {},
                     .pictures = {}};
  const bool has_surface = line.run.surface != SurfaceKind::kNone;
  for (const std::string& output : {has_surface ? line.run.output : "", line.run.tetrahedra,
                                    line.run.unused, line.run.medial_axis}) {
    if (!output.empty()) page.outputs.push_back(output == "-" ? "standard output" : output);
  }
  if (line.run.resume) {
    page.note =
        "Run with --resume: where it went on from an earlier run, times, stages and memory are "
        "those of the last part.";
  }
  if (has_surface && line.run.output != "-") {
    page.pictures = html::draw_run_pictures(line.run.output, report.memory_budget_bytes);
  }
  html::write_run_page(page, line.html);
}

void reconstruct_and_report(CommandLine& line, StopRequest& stop) {
  const std::map<std::string, SurfaceKind> kinds{
      {"gamma", SurfaceKind::kGamma},   {"alpha", SurfaceKind::kAlpha},
      {"solid", SurfaceKind::kSolid},   {"crust", SurfaceKind::kCrust},
      {"hybrid", SurfaceKind::kHybrid}, {"none", SurfaceKind::kNone}};
  line.run.surface = kinds.at(line.surface);
  line.run.stop = &stop;
  line.run.on_notice = [](const std::string& notice) { spdlog::warn("{}", notice); };
  if (line.run.surface == SurfaceKind::kNone && !line.run.output.empty()) {
    spdlog::warn("--surface none makes no surface: nothing is written to {}", line.run.output);
  }
  try_html(line.html);
  const Report report = reconstruct(line.run);
  if (!line.report.empty()) write_report(report, line.report);
  if (!line.html.empty()) write_html(line, report);
}

int run(CommandLine& line) {
  StopRequest stop;
  const SignalWatch watch(stop);
  try {
    reconstruct_and_report(line, stop);
    return kDone;
  } catch (const BudgetError& e) {
    spdlog::error("{}", e.what());
    return kNoMemory;
  } catch (const Interrupted& e) {
    spdlog::error("{}", e.what());
    return e.is_resumable() ? kResumable : kInterrupted;
  }
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Surfaces from huge point clouds, exactly and in a fixed memory budget",
               "stream-recon");
  CommandLine line;
  line.words.assign(argv, argv + argc);
  line.words.front() = "stream-recon";
  add_input_options(app, line);
  add_surface_options(app, line);
  add_resource_options(app, line);
  add_report_options(app, line);
  int code = kDone;
  const int tool_code = run_tool(app, argc, argv, [&] {
    check_combinations(app, line);
    code = run(line);
  });
  return tool_code != kDone ? tool_code : code;
}
