// What every small program does around its work: parse options, turn errors into one line on
// standard error and an exit code. Every program has --help and --version.
//
// Exit codes: 0 done, 64 usage, 65 bad input, 70 internal check failed, 74 I/O error.
#pragma once

#include <CLI/CLI.hpp>
#include <functional>

namespace stream_recon {

/// Parses the command line into `app` and runs `work`; returns the exit code. std::invalid_argument
/// from `work` is a usage error.
int run_tool(CLI::App& app, int argc, char** argv, const std::function<void()>& work);

}  // namespace stream_recon
