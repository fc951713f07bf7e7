// How voxels lie in a file that has no header, as the user tells it.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "io/scalar_type.h"

namespace stream_recon {

using RawType = ScalarType;

struct RawLayout {
  std::array<std::size_t, 3> dims{};  ///< voxels along i, j, k; of all files together
  RawType type = RawType::kUint8;
  bool big_endian = false;
  std::uint64_t skip = 0;  ///< bytes before the first voxel of each file
};

}  // namespace stream_recon
