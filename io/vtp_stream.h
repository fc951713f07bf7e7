// The bytes of one array of a VTK XML file, decoded from text, base64 or raw, and decompressed.
//
// Guarantees: read() gives the array's bytes in order and fewer than asked only at its end; an
// array that is cut, damaged or of another size than promised is an InputError.
// Memory: one block of the writer (at most kLongestVtpBlock, 32 KiB by default) and 4 bytes for
// each block of the array. Thread rule: one reader. zlib and LZ4 data are known. Source: "VTK File
// Formats" (Kitware), XML formats, and the layout of compressed blocks there.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string_view>

#include "io/byte_source.h"
#include "io/scalar_type.h"

namespace stream_recon {

inline constexpr std::uint64_t kLongestVtpBlock = 64 << 20;

enum class VtpCompressor { kNone, kZlib, kLz4 };

/// How a file stores its binary arrays: the attributes of <VTKFile>.
struct VtpEncoding {
  std::endian order = std::endian::little;
  ScalarType header = ScalarType::kUint32;  ///< of the numbers before an array, or kUint64
  VtpCompressor compressor = VtpCompressor::kNone;
};

/// A run of characters: of an element, or of an appended section.
class VtpText {
 public:
  virtual ~VtpText() = default;
  /// The next characters, empty at the end; the view holds until the next call of peek().
  virtual std::string_view peek() = 0;
  virtual void consume(std::size_t count) = 0;
};

class VtpStream {
 public:
  virtual ~VtpStream() = default;
  /// Fills `out`; fewer bytes only at the end. \throw InputError, IoError
  virtual std::size_t read(std::span<char> out) = 0;
};

/// The bytes of `source` as they are.
std::unique_ptr<VtpStream> make_raw_stream(ByteSource& source);

/// Base64, which may be padded in the middle; white space is ignored. `source` is named in errors.
std::unique_ptr<VtpStream> make_base64_stream(VtpText& text, const ByteSource& source);

/// Numbers in text as native values of `type`.
std::unique_ptr<VtpStream> make_number_stream(VtpText& text, ScalarType type,
                                              const ByteSource& source);

/// The content of an array behind its length or block header. `expected` is its size in bytes,
/// where that is known otherwise. `source` is named in errors.
struct VtpArrayLayout {
  VtpEncoding encoding;
  std::optional<std::uint64_t> expected;
};
std::unique_ptr<VtpStream> make_array_stream(std::unique_ptr<VtpStream> stored,
                                             const VtpArrayLayout& layout,
                                             const ByteSource& source);

}  // namespace stream_recon
