// Words, counts and skippable blocks of a legacy VTK file.
//
// Guarantees: what is stepped over is stepped over as a whole, or the file is refused.
// Memory: none beyond the source's window. Thread rule: one reader.
// Source: "VTK File Formats" (Kitware), simple legacy formats; the layout of binary strings and of
// METADATA blocks as VTK 9 writes them.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "io/byte_source.h"
#include "io/scalar_type.h"
#include "io/text_reader.h"

namespace stream_recon {

class VtkLegacyScanner {
 public:
  VtkLegacyScanner(ByteSource& source, TextReader& text) : source_(source), text_(text) {}

  /// Whether arrays are binary, once the file has said so.
  void set_binary(bool binary) { binary_ = binary; }

  /// Keywords and types are the same in any case.
  static std::string lower(std::string_view text);
  /// The type of a name in lower case, as VTK stores it: long has 8 bytes, vtkIdType 4.
  static std::optional<ScalarType> type_named(std::string_view name);

  std::uint64_t take_count();
  /// Takes the rest of a line, which must be blank.
  void end_line();
  /// \throw InputError beyond 64 bits
  std::uint64_t product(std::uint64_t a, std::uint64_t b) const;

  /// Steps over a FIELD behind its keyword.
  void skip_field();
  /// Steps over METADATA behind its keyword: lines up to an empty one.
  void skip_metadata();

  [[noreturn]] void fail_end() const;

 private:
  void skip_words(const std::string& type, std::uint64_t values);
  void skip_binary(const std::string& type, std::uint64_t values);
  void skip_string();

  ByteSource& source_;
  TextReader& text_;
  bool binary_ = false;
};

}  // namespace stream_recon
