// Voxels as they lie in a file, and as doubles.
//
// Guarantees: widening is exact but for 64-bit integers, which are rounded to the nearest double.
// Nothing is assumed about alignment. Thread rule: stateless. Cost: that of a copy.
#pragma once

#include <bit>
#include <cstddef>
#include <span>
#include <string_view>

#include "tools/slices/raw_layout.h"

namespace stream_recon {

struct VoxelFormat {
  RawType type = RawType::kUint8;
  std::endian order = std::endian::little;

  bool operator==(const VoxelFormat&) const = default;
};

/// Fills `out` from its size times scalar_size(format.type) bytes.
void widen_voxels(const std::byte* bytes, VoxelFormat format, std::span<double> out);

/// "8-bit unsigned" and so on, for messages.
std::string_view name_of(RawType type);

}  // namespace stream_recon
