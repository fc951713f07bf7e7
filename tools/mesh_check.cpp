// mesh-check: what is wrong with a mesh, however large.

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <cstdio>
#include <span>
#include <string>
#include <vector>

#include "engine/size_text.h"
#include "engine/version.h"
#include "io/file.h"
#include "tools/check/facts_text.h"
#include "tools/check/mesh_check.h"
#include "tools/check/requirements.h"
#include "tools/run_tool.h"

namespace {

using namespace stream_recon;

enum ExitCode { kDone = 0, kUnmet = 1, kNoMemory = 69, kInterrupted = 130 };

struct CommandLine {
  MeshCheckOptions check;
  std::vector<std::string> require;
  bool json = false;
};

void add_options(CLI::App& app, CommandLine& line) {
  const auto read_size = [&line](const CLI::results_t& texts) {
    const auto size = parse_size(texts.at(0));
    line.check.memory_bytes = size.value_or(0);
    return size.has_value();
  };
  app.add_option("MESH", line.check.path,
                 "Chunked mesh (.pvtp), .vtp, .ply or .vtk; - is PLY on standard input")
      ->required();
  app.add_flag("--json", line.json, "JSON on standard output instead of a table");
  app.add_option("--require", line.require,
                 fmt::format("What must hold, else exit code 1; of {}",
                             fmt::join(requirement_names(), ", ")))
      ->delimiter(',')
      ->allow_extra_args(false)
      ->check(CLI::IsMember(requirement_names()))
      ->option_text("LIST");
  app.add_option("--memory", read_size,
                 "Peak resident memory of the process, e.g. 64M or 1G (default: 512M)")
      ->option_text("SIZE");
  app.add_option("--threads", line.check.threads, "Threads (default: all of the machine)")
      ->check(CLI::Range(1U, 4096U))
      ->option_text("N");
  app.add_option("--scratch", line.check.scratch,
                 "Folder for temporary files (default: $TMPDIR, else /var/tmp)")
      ->option_text("DIR");
}

int check_and_print(CommandLine& line, StopRequest& stop) {
  line.check.stop = &stop;
  const MeshFacts facts = check_mesh(line.check);
  const std::string text = line.json ? facts_json(facts) : facts_table(facts);
  File::standard_output().write(std::as_bytes(std::span(text)));
  const std::string unmet = unmet_requirements(facts, line.require);
  if (unmet.empty()) return kDone;
  spdlog::error("{}: {}", line.check.path, unmet);
  return kUnmet;
}

int run(CommandLine& line) {
  StopRequest stop;
  const SignalWatch watch(stop);
  try {
    return check_and_print(line, stop);
  } catch (const BudgetError& e) {
    spdlog::error("{}", e.what());
    return kNoMemory;
  } catch (const Interrupted& e) {
    spdlog::error("{}", e.what());
    return kInterrupted;
  }
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Counts what can be wrong with a triangle mesh, however large", "mesh-check");
  app.set_version_flag("--version", fmt::format("mesh-check {}", version()));
  CommandLine line;
  add_options(app, line);
  int code = kDone;
  const int tool_code = run_tool(app, argc, argv, [&] { code = run(line); });
  return tool_code != kDone ? tool_code : code;
}
