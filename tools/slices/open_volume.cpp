#include "tools/slices/open_volume.h"

#include <stdexcept>

#include "tools/slices/volume_file.h"

namespace stream_recon {

std::unique_ptr<Volume> open_volume(const VolumeRequest& request) {
  if (request.paths.empty()) throw std::invalid_argument("no volume is named; name a file");
  return open_volume_file(request.paths.front());
}

}  // namespace stream_recon
