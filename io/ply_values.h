// The values of a PLY body one after the other, whether they are text or bytes.
//
// Guarantees: a value comes with the exact value its property declares; the end of the file within
// the body is an InputError, and so is a last word of text without a line end, whose digits may be
// missing. Memory: the source's window. Cost: about 5 ns a binary value. Thread rule: one reader.
#pragma once

#include <cstdint>

#include "io/byte_source.h"
#include "io/ply_header.h"
#include "io/text_reader.h"

namespace stream_recon {

class PlyValues {
 public:
  /// `source` stands at the first byte of the body, and outlives the object.
  PlyValues(ByteSource& source, const PlyHeader& header)
      : source_(source), text_(source, header.lines), format_(header.format) {}

  /// \pre the type has a decoder (io/scalar_type.h) \throw InputError, IoError
  double take_number(ScalarType type);
  /// \throw InputError also if negative or no integer; IoError
  std::uint64_t take_index(ScalarType type);
  /// \throw InputError, IoError
  void skip(const PlyProperty& property);
  void skip(const PlyElement& element);
  /// Nothing but white space is left. \throw InputError
  void check_end();

  [[noreturn]] void fail(const std::string& what) const;

 private:
  bool is_text() const { return format_ == PlyFormat::kAscii; }
  std::endian order() const {
    return format_ == PlyFormat::kBinaryBigEndian ? std::endian::big : std::endian::little;
  }
  std::string_view take_word();
  const char* peek(std::size_t size);

  ByteSource& source_;
  TextReader text_;
  PlyFormat format_;
};

}  // namespace stream_recon
