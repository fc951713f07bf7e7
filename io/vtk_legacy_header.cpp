#include "io/vtk_legacy_header.h"

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <utility>

#include "io/number_text.h"

namespace stream_recon {
namespace {

std::string lower(std::string_view text) {
  std::string result(text);
  std::transform(result.begin(), result.end(), result.begin(), [](char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  });
  return result;
}

/// As the format's writer stores them: long has 8 bytes, vtkIdType 4.
std::optional<ScalarType> type_named(std::string_view name) {
  static constexpr std::pair<std::string_view, ScalarType> kNames[] = {
      {"char", ScalarType::kInt8},
      {"signed_char", ScalarType::kInt8},
      {"unsigned_char", ScalarType::kUint8},
      {"short", ScalarType::kInt16},
      {"unsigned_short", ScalarType::kUint16},
      {"int", ScalarType::kInt32},
      {"unsigned_int", ScalarType::kUint32},
      {"vtkidtype", ScalarType::kInt32},
      {"long", ScalarType::kInt64},
      {"unsigned_long", ScalarType::kUint64},
      {"vtktypeint64", ScalarType::kInt64},
      {"vtktypeuint64", ScalarType::kUint64},
      {"float", ScalarType::kFloat32},
      {"double", ScalarType::kFloat64}};
  const auto* found = std::find_if(std::begin(kNames), std::end(kNames),
                                   [&](const auto& entry) { return entry.first == name; });
  if (found == std::end(kNames)) return std::nullopt;
  return found->second;
}

class HeaderParser {
 public:
  HeaderParser(ByteSource& source, TextReader& text) : source_(source), text_(text) {}

  VtkLegacyHeader parse() {
    parse_first_lines();
    for (;;) {
      const std::string word = lower(text_.next_word());
      if (word.empty()) fail_end();
      if (word == "dataset") {
        parse_dataset();
      } else if (word == "dimensions") {
        std::array<std::uint64_t, 3> sides{};
        for (std::uint64_t& side : sides) side = take_count();
        grid_points_ = product(product(sides[0], sides[1]), sides[2]);
      } else if (word == "field") {
        skip_field();
      } else if (word == "metadata") {
        skip_metadata();
      } else if (word == "points") {
        return parse_points();
      } else {
        text_.fail("unexpected " + quoted(word) + " before POINTS; correct the VTK file");
      }
    }
  }

 private:
  void parse_first_lines() {
    constexpr std::string_view kMagic = "# vtk DataFile Version ";
    std::string_view line;
    if (!text_.next_line(line) || !line.starts_with(kMagic)) {
      source_.fail_at(0,
                      "not a legacy VTK file: it does not start with \"# vtk DataFile\"; check " +
                          std::string("--input-format"));
    }
    const std::string_view version = line.substr(kMagic.size());
    if (version.empty() || version.front() < '1' || version.front() > '5' ||
        (version.size() > 1 && version[1] != '.')) {
      text_.fail("unknown VTK file version " + quoted(version) + "; known are 1.0 to 5.x");
    }
    if (!text_.next_line(line) || !text_.next_line(line)) fail_end();
    const std::string encoding = lower(line.substr(0, line.find_last_not_of(" \t") + 1));
    if (encoding != "ascii" && encoding != "binary") {
      text_.fail(quoted(line) + " where ASCII or BINARY should be; correct the VTK file");
    }
    header_.binary = encoding == "binary";
  }

  void parse_dataset() {
    const std::string kind = lower(text_.next_word());
    if (kind.empty()) fail_end();
    if (kind != "polydata" && kind != "unstructured_grid" && kind != "structured_grid") {
      text_.fail("a dataset " + quoted(kind) + " has no list of points; give a POLYDATA, " +
                 "UNSTRUCTURED_GRID or STRUCTURED_GRID");
    }
    has_dataset_ = true;
    has_grid_ = kind == "structured_grid";
  }

  VtkLegacyHeader parse_points() {
    if (!has_dataset_) text_.fail("POINTS before DATASET; correct the VTK file");
    header_.points = take_count();
    const std::string name = lower(text_.next_word());
    const std::optional<ScalarType> type = type_named(name);
    if (!type || scalar_decoder(*type, std::endian::big) == nullptr) {
      text_.fail("coordinates of type " + quoted(name) +
                 " are not read exactly; store them as float, double or int");
    }
    header_.type = *type;
    if (has_grid_ && grid_points_ != header_.points) {
      text_.fail("DIMENSIONS and POINTS do not fit; correct the VTK file");
    }
    end_line();
    return header_;
  }

  void skip_field() {
    text_.next_word();
    const std::uint64_t arrays = take_count();
    for (std::uint64_t i = 0; i < arrays; ++i) {
      std::string_view name = text_.next_word();
      while (lower(name) == "metadata") {
        skip_metadata();
        name = text_.next_word();
      }
      if (name.empty()) fail_end();
      const std::uint64_t components = take_count();
      const std::uint64_t values = product(components, take_count());
      const std::string type = lower(text_.next_word());
      end_line();
      if (header_.binary) {
        skip_binary(type, values);
      } else {
        skip_words(type, values);
      }
    }
  }

  void skip_words(const std::string& type, std::uint64_t values) {
    for (std::uint64_t i = 0; i < values; ++i) {
      // A string has a line to itself, and may be empty.
      const bool taken = type == "string" ? text_.skip_line() : !text_.next_word().empty();
      if (!taken) fail_end();
    }
  }

  void skip_binary(const std::string& type, std::uint64_t values) {
    if (type == "string") {
      for (std::uint64_t i = 0; i < values; ++i) skip_string();
      return;
    }
    std::uint64_t bytes = values / 8 + (values % 8 != 0 ? 1 : 0);
    if (type != "bit") {
      const std::optional<ScalarType> known = type_named(type);
      if (!known) text_.fail("unknown type " + quoted(type) + " in field data; leave it out");
      bytes = product(values, scalar_size(*known));
    }
    if (source_.skip(bytes) != bytes) fail_end();
  }

  /// The two top bits of the first byte tell how many bytes the length has: 8, 4, 2 or 1.
  void skip_string() {
    const std::string_view first = source_.peek(1);
    if (first.empty()) fail_end();
    const auto head = static_cast<unsigned char>(first.front());
    const std::size_t size = std::size_t{8} >> (head >> 6);
    const std::string_view bytes = source_.peek(size);
    if (bytes.size() < size) fail_end();
    std::uint64_t length = head & 0x3f;
    for (std::size_t i = 1; i < size; ++i) {
      length = length << 8 | static_cast<unsigned char>(bytes[i]);
    }
    source_.consume(size);
    if (source_.skip(length) != length) fail_end();
  }

  /// Names and values, a line each, up to an empty line.
  void skip_metadata() {
    end_line();
    std::string_view line;
    do {
      if (!text_.next_line(line)) fail_end();
    } while (!line.empty());
  }

  void end_line() {
    std::string_view rest;
    if (!text_.next_line(rest)) fail_end();
    if (rest.find_first_not_of(" \t") != std::string_view::npos) {
      text_.fail("unexpected " + quoted(rest) + " at the end of the line; correct the VTK file");
    }
  }

  std::uint64_t take_count() {
    const std::string_view word = text_.next_word();
    const std::optional<std::uint64_t> count = whole_count(word);
    if (!count) text_.fail(quoted(word) + " where a count should be; correct the VTK file");
    return *count;
  }

  std::uint64_t product(std::uint64_t a, std::uint64_t b) const {
    std::uint64_t result = 0;
    if (__builtin_mul_overflow(a, b, &result)) {
      text_.fail("an impossible count; the VTK file is damaged");
    }
    return result;
  }

  [[noreturn]] void fail_end() const {
    source_.fail("the file ends before its points; it is cut short, fetch it again");
  }

  ByteSource& source_;
  TextReader& text_;
  VtkLegacyHeader header_;
  bool has_dataset_ = false;
  bool has_grid_ = false;
  std::uint64_t grid_points_ = 0;
};

}  // namespace

VtkLegacyHeader read_vtk_legacy_header(ByteSource& source, TextReader& text) {
  return HeaderParser(source, text).parse();
}

}  // namespace stream_recon
