#include <engine/reconstruct.h>

#include <iostream>

int main(int, char** arguments) {
  stream_recon::RunOptions options;
  options.inputs = {arguments[1]};
  options.output = arguments[2];
  const stream_recon::Report report = stream_recon::reconstruct(options);
  std::cout << report.surface.triangles << " triangles\n";
}
