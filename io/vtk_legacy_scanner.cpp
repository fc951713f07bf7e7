#include "io/vtk_legacy_scanner.h"

#include <algorithm>
#include <utility>

#include "io/number_text.h"

namespace stream_recon {

std::string VtkLegacyScanner::lower(std::string_view text) {
  std::string result(text);
  std::transform(result.begin(), result.end(), result.begin(), [](char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  });
  return result;
}

std::optional<ScalarType> VtkLegacyScanner::type_named(std::string_view name) {
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

void VtkLegacyScanner::end_line() {
  std::string_view rest;
  if (!text_.next_line(rest)) fail_end();
  if (rest.find_first_not_of(" \t") != std::string_view::npos) {
    text_.fail("unexpected " + quote_text(rest) + " at the end of the line; correct the VTK file");
  }
}

std::uint64_t VtkLegacyScanner::take_count() {
  const std::string_view word = text_.next_word();
  const std::optional<std::uint64_t> count = whole_count(word);
  if (!count) text_.fail(quote_text(word) + " where a count should be; correct the VTK file");
  return *count;
}

std::uint64_t VtkLegacyScanner::product(std::uint64_t a, std::uint64_t b) const {
  std::uint64_t result = 0;
  if (__builtin_mul_overflow(a, b, &result)) {
    text_.fail("an impossible count; the VTK file is damaged");
  }
  return result;
}

void VtkLegacyScanner::skip_field() {
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
    if (binary_) {
      skip_binary(type, values);
    } else {
      skip_words(type, values);
    }
  }
}

void VtkLegacyScanner::skip_words(const std::string& type, std::uint64_t values) {
  for (std::uint64_t i = 0; i < values; ++i) {
    // A string has a line to itself, and may be empty.
    const bool taken = type == "string" ? text_.skip_line() : !text_.next_word().empty();
    if (!taken) fail_end();
  }
}

void VtkLegacyScanner::skip_binary(const std::string& type, std::uint64_t values) {
  if (type == "string") {
    for (std::uint64_t i = 0; i < values; ++i) skip_string();
    return;
  }
  std::uint64_t bytes = values / 8 + (values % 8 != 0 ? 1 : 0);
  if (type != "bit") {
    const std::optional<ScalarType> known = type_named(type);
    if (!known) text_.fail("unknown type " + quote_text(type) + " in field data; leave it out");
    bytes = product(values, scalar_size(*known));
  }
  if (source_.skip(bytes) != bytes) fail_end();
}

// The two top bits of the first byte tell how many bytes the length has: 8, 4, 2 or 1.
void VtkLegacyScanner::skip_string() {
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

void VtkLegacyScanner::skip_metadata() {
  end_line();
  std::string_view line;
  do {
    if (!text_.next_line(line)) fail_end();
  } while (!line.empty());
}

void VtkLegacyScanner::fail_end() const {
  source_.fail("the file ends before its points; it is cut short, fetch it again");
}

}  // namespace stream_recon
