// The number types point formats store, and how their bytes become a double.
//
// Guarantees: decoding is exact; 64-bit integers, which a double cannot hold exactly, have no
// decoder. Nothing is assumed about alignment. Thread rule: stateless.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>

namespace stream_recon {

enum class ScalarType : std::uint8_t {
  kInt8,
  kUint8,
  kInt16,
  kUint16,
  kInt32,
  kUint32,
  kInt64,
  kUint64,
  kFloat32,
  kFloat64
};

/// Bytes of one value.
std::size_t scalar_size(ScalarType type);

constexpr bool is_floating(ScalarType type) {
  return type == ScalarType::kFloat32 || type == ScalarType::kFloat64;
}

/// Reads the value at `bytes`.
using ScalarDecoder = double (*)(const char* bytes);

/// nullptr for the 64-bit integers.
ScalarDecoder scalar_decoder(ScalarType type, std::endian order);

/// The T stored at `bytes` in the given byte order.
template <typename T>
T load_scalar(const char* bytes, std::endian order) {
  char native[sizeof(T)];
  if (order == std::endian::native) {
    std::memcpy(native, bytes, sizeof(T));
  } else {
    for (std::size_t i = 0; i < sizeof(T); ++i) native[i] = bytes[sizeof(T) - 1 - i];
  }
  T value;
  std::memcpy(&value, native, sizeof(T));
  return value;
}

}  // namespace stream_recon
