#include <cstdio>

#include "io/point_source.h"
#include "spatial/simplex_digest.h"

int main() {
  stream_recon::SimplexDigest digest;
  std::printf("%s\n", digest.hex().c_str());
}
