#include "tools/slices/raw_volume.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "io/error.h"
#include "tools/slices/packed_volume.h"

namespace stream_recon {

std::unique_ptr<Volume> open_raw_volume(const std::vector<std::string>& paths,
                                        const RawLayout& raw) {
  if (std::find(raw.dims.begin(), raw.dims.end(), 0U) != raw.dims.end())
    throw std::invalid_argument("a raw volume needs at least one voxel along each axis");
  if (paths.size() > 1 && raw.dims[2] != paths.size()) {
    throw InputError(fmt::format("{}: {} raw files for {} slices; name one file, or one for each",
                                 paths.front(), paths.size(), raw.dims[2]));
  }
  VoxelLayout layout;
  layout.files = paths;
  layout.format = {raw.type, raw.big_endian ? std::endian::big : std::endian::little};
  layout.start = raw.skip;
  layout.exact_length = true;
  VolumeGeometry geometry;
  geometry.size = raw.dims;
  geometry.step = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  geometry.has_spacing = false;
  return open_packed_volume(layout, geometry,
                            fmt::format("{} ({} raw files)", paths.front(), paths.size()));
}

}  // namespace stream_recon
