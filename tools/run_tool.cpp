#include "tools/run_tool.h"

#include <spdlog/sinks/stdout_sinks.h>
#include <spdlog/spdlog.h>

#include <csignal>
#include <exception>
#include <new>
#include <stdexcept>
#include <string>

#include "io/error.h"

namespace stream_recon {
namespace {

enum ExitCode { kDone = 0, kUsage = 64, kBadInput = 65, kInternal = 70, kIo = 74 };

int fail(ExitCode code, std::string message) {
  for (char& c : message)
    if (c == '\n') c = ' ';
  spdlog::error("{}", message);
  return code;
}

int run(const std::function<void()>& work) {
  try {
    work();
    return kDone;
  } catch (const InputError& e) {
    return fail(kBadInput, e.what());
  } catch (const IoError& e) {
    return fail(kIo, e.what());
  } catch (const std::invalid_argument& e) {
    return fail(kUsage, e.what());
  } catch (const std::bad_alloc&) {
    return fail(kInternal, "out of memory: free some, or take a smaller input");
  } catch (const std::exception& e) {
    return fail(kInternal, e.what());
  }
}

}  // namespace

int run_tool(CLI::App& app, int argc, char** argv, const std::function<void()>& work) {
  spdlog::set_default_logger(spdlog::stderr_logger_st(app.get_name()));
  spdlog::set_pattern("%n: %v");
  std::signal(SIGPIPE, SIG_IGN);  // a closed pipe is an I/O error like any other
  app.set_version_flag("--version", app.get_name() + " " STREAM_RECON_VERSION);
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& help) {
    return app.exit(help);
  } catch (const CLI::ParseError& e) {
    return fail(kUsage, std::string(e.what()) + "; see " + app.get_name() + " --help");
  }
  return run(work);
}

}  // namespace stream_recon
