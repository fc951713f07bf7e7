#include "tools/slices/quiet_streams.h"

#include <fcntl.h>
#include <unistd.h>

#include <cstdio>
#include <iostream>

namespace stream_recon {
namespace {

void flush_all() {
  std::cout.flush();
  std::cerr.flush();
  std::fflush(nullptr);
}

void restore(int saved, int stream) {
  if (saved < 0) return;
  dup2(saved, stream);
  close(saved);
}

}  // namespace

QuietStreams::QuietStreams() {
  flush_all();
  output_ = dup(STDOUT_FILENO);
  error_ = dup(STDERR_FILENO);
  const int nowhere = open("/dev/null", O_WRONLY | O_CLOEXEC);
  if (nowhere < 0) return;
  dup2(nowhere, STDOUT_FILENO);
  dup2(nowhere, STDERR_FILENO);
  close(nowhere);
}

QuietStreams::~QuietStreams() {
  flush_all();
  restore(output_, STDOUT_FILENO);
  restore(error_, STDERR_FILENO);
}

}  // namespace stream_recon
