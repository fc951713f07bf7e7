// One run in a process of its own, to be killed: the restart tests start it.
//
//     restart_driver OPERATIONS CALL CLOUD OUT WINDOW_POINTS THREADS [resume]
//
// OPERATIONS are bits of IoOperation; the CALL-th of them kills the process (-1: none does).

#include <cstdio>
#include <cstdlib>
#include <exception>
#include <optional>
#include <string>
#include <vector>

#include "engine/reconstruct.h"
#include "io/fault_injection.h"

int main(int argc, char** argv) {
  using namespace stream_recon;
  if (argc < 7) return 64;
  const std::vector<std::string> arguments(argv, argv + argc);
  RunOptions options;
  options.inputs = {arguments[3]};
  options.output = arguments[4] + ".pvtp";
  options.tetrahedra = arguments[4] + "-t.pvtu";
  options.unused = arguments[4] + "-u.ply";
  options.medial_axis = arguments[4] + "-m.pvtp";
  options.chunk_points = 500;
  options.window_points = std::stoull(arguments[5]);
  options.threads = static_cast<unsigned>(std::stoul(arguments[6]));
  options.resume = argc > 7;

  FaultPlan plan{.operations = static_cast<unsigned>(std::stoul(arguments[1])), .error = 5};
  const long call = std::stol(arguments[2]);
  plan.fail_at = static_cast<std::uint64_t>(call);
  plan.kills = true;
  std::optional<ScopedFault> fault;
  if (call >= 0) fault.emplace(plan);
  try {
    (void)reconstruct(options);
    return 0;
  } catch (const std::exception& e) {
    std::fprintf(stderr, "%s\n", e.what());
    return 1;
  }
}
