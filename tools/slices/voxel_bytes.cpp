#include "tools/slices/voxel_bytes.h"

#include <cstdint>

namespace stream_recon {
namespace {

template <typename Voxel>
void widen(const std::byte* bytes, std::endian order, std::span<double> out) {
  const auto* at = reinterpret_cast<const char*>(bytes);
  const auto convert = [&](std::endian known) {
    for (double& voxel : out) {
      voxel = static_cast<double>(load_scalar<Voxel>(at, known));
      at += sizeof(Voxel);
    }
  };
  // A constant order in each loop lets the compiler make vectors of it.
  if (order == std::endian::little) {
    convert(std::endian::little);
  } else {
    convert(std::endian::big);
  }
}

}  // namespace

void widen_voxels(const std::byte* bytes, VoxelFormat format, std::span<double> out) {
  switch (format.type) {
    case RawType::kInt8:
      return widen<std::int8_t>(bytes, format.order, out);
    case RawType::kUint8:
      return widen<std::uint8_t>(bytes, format.order, out);
    case RawType::kInt16:
      return widen<std::int16_t>(bytes, format.order, out);
    case RawType::kUint16:
      return widen<std::uint16_t>(bytes, format.order, out);
    case RawType::kInt32:
      return widen<std::int32_t>(bytes, format.order, out);
    case RawType::kUint32:
      return widen<std::uint32_t>(bytes, format.order, out);
    case RawType::kInt64:
      return widen<std::int64_t>(bytes, format.order, out);
    case RawType::kUint64:
      return widen<std::uint64_t>(bytes, format.order, out);
    case RawType::kFloat32:
      return widen<float>(bytes, format.order, out);
    case RawType::kFloat64:
      return widen<double>(bytes, format.order, out);
  }
}

std::string_view name_of(RawType type) {
  switch (type) {
    case RawType::kInt8:
      return "8-bit signed";
    case RawType::kUint8:
      return "8-bit unsigned";
    case RawType::kInt16:
      return "16-bit signed";
    case RawType::kUint16:
      return "16-bit unsigned";
    case RawType::kInt32:
      return "32-bit signed";
    case RawType::kUint32:
      return "32-bit unsigned";
    case RawType::kInt64:
      return "64-bit signed";
    case RawType::kUint64:
      return "64-bit unsigned";
    case RawType::kFloat32:
      return "32-bit float";
    case RawType::kFloat64:
      return "64-bit float";
  }
  return "unknown";
}

}  // namespace stream_recon
