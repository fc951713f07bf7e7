// The header of a PLY file: what stands in the body, element by element.
//
// Guarantees: what is returned is consistent: a vertex element with scalar x, y, z of a type a
// double holds exactly; list counts are integers. Line ends may be "\n" or "\r\n".
// Memory: at most kLongestPlyHeader bytes of header, whatever it promises.
// Source: G. Turk, "The PLY Polygon File Format", 1994; type names with sizes (int8 ... float64)
// as later programs write them.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "io/byte_source.h"
#include "io/scalar_type.h"

namespace stream_recon {

inline constexpr std::uint64_t kLongestPlyHeader = 1 << 20;

enum class PlyFormat { kAscii, kBinaryLittleEndian, kBinaryBigEndian };

struct PlyProperty {
  std::string name;
  ScalarType type = ScalarType::kFloat32;  ///< of the value or of the list's items
  bool is_list = false;
  ScalarType count_type = ScalarType::kUint8;  ///< of the list's length
};

struct PlyElement {
  std::string name;
  std::uint64_t count = 0;
  std::vector<PlyProperty> properties;

  bool has_list() const;
  /// Bytes of one element without lists in a binary body.
  std::size_t fixed_size() const;
};

struct PlyHeader {
  PlyFormat format = PlyFormat::kAscii;
  std::vector<PlyElement> elements;
  std::size_t vertex = 0;             ///< position of the vertex element in `elements`
  std::array<std::size_t, 3> axes{};  ///< positions of x, y, z among the vertex' properties
  std::uint64_t lines = 0;            ///< lines of the header, for messages about an ascii body

  const PlyElement& vertices() const { return elements[vertex]; }
};

/// Reads the header and leaves `source` at the first byte of the body.
/// \throw InputError malformed header, no points in it, or a type that is not exact
PlyHeader read_ply_header(ByteSource& source);

}  // namespace stream_recon
