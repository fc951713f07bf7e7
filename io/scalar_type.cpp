#include "io/scalar_type.h"

#include <array>

namespace stream_recon {
namespace {

template <typename T, std::endian kOrder>
double decode(const char* bytes) {
  return static_cast<double>(load_scalar<T>(bytes, kOrder));
}

template <std::endian kOrder>
ScalarDecoder decoder(ScalarType type) {
  switch (type) {
    case ScalarType::kInt8:
      return decode<std::int8_t, kOrder>;
    case ScalarType::kUint8:
      return decode<std::uint8_t, kOrder>;
    case ScalarType::kInt16:
      return decode<std::int16_t, kOrder>;
    case ScalarType::kUint16:
      return decode<std::uint16_t, kOrder>;
    case ScalarType::kInt32:
      return decode<std::int32_t, kOrder>;
    case ScalarType::kUint32:
      return decode<std::uint32_t, kOrder>;
    case ScalarType::kFloat32:
      return decode<float, kOrder>;
    case ScalarType::kFloat64:
      return decode<double, kOrder>;
    case ScalarType::kInt64:
    case ScalarType::kUint64:
      break;
  }
  return nullptr;
}

}  // namespace

std::size_t scalar_size(ScalarType type) {
  constexpr std::array<std::size_t, 10> kSizes{1, 1, 2, 2, 4, 4, 8, 8, 4, 8};
  return kSizes[static_cast<std::size_t>(type)];
}

ScalarDecoder scalar_decoder(ScalarType type, std::endian order) {
  return order == std::endian::little ? decoder<std::endian::little>(type)
                                      : decoder<std::endian::big>(type);
}

}  // namespace stream_recon
