#include "io/ply_values.h"

#include <optional>
#include <string>

#include "io/number_text.h"

namespace stream_recon {
namespace {

constexpr const char* kShort = "the file ends inside its body; it is cut short, fetch it again";

/// Negative values wrap to huge ones.
std::uint64_t load_integer(const char* bytes, ScalarType type, std::endian order) {
  const auto widened = [](auto value) {
    return static_cast<std::uint64_t>(static_cast<std::int64_t>(value));
  };
  switch (type) {
    case ScalarType::kInt8:
      return widened(load_scalar<std::int8_t>(bytes, order));
    case ScalarType::kUint8:
      return load_scalar<std::uint8_t>(bytes, order);
    case ScalarType::kInt16:
      return widened(load_scalar<std::int16_t>(bytes, order));
    case ScalarType::kUint16:
      return load_scalar<std::uint16_t>(bytes, order);
    case ScalarType::kInt32:
      return widened(load_scalar<std::int32_t>(bytes, order));
    case ScalarType::kUint32:
      return load_scalar<std::uint32_t>(bytes, order);
    default:
      return load_scalar<std::uint64_t>(bytes, order);
  }
}

}  // namespace

double PlyValues::take_number(ScalarType type) {
  if (!is_text()) {
    const double value = scalar_decoder(type, order())(peek(scalar_size(type)));
    source_.consume(scalar_size(type));
    return value;
  }
  const std::string_view word = take_word();
  const std::optional<double> value =
      type == ScalarType::kFloat32 ? whole_float(word) : whole_double(word);
  if (!value) fail(quote_text(word) + " is no number; correct the line or the PLY header");
  return *value;
}

std::uint64_t PlyValues::take_index(ScalarType type) {
  if (is_text()) {
    const std::string_view word = take_word();
    const std::optional<std::uint64_t> value = whole_count(word);
    if (!value) fail(quote_text(word) + " is no count or index; correct the line");
    return *value;
  }
  if (is_floating(type)) fail("an index that is no integer; correct the PLY header");
  const std::uint64_t value = load_integer(peek(scalar_size(type)), type, order());
  if (value >> 63 != 0) fail("an index is negative; the file is damaged");
  source_.consume(scalar_size(type));
  return value;
}

void PlyValues::skip(const PlyProperty& property) {
  std::uint64_t values = property.is_list ? take_index(property.count_type) : 1;
  if (is_text()) {
    while (values-- > 0) take_word();
    return;
  }
  std::uint64_t bytes = 0;
  if (__builtin_mul_overflow(values, scalar_size(property.type), &bytes) ||
      source_.skip(bytes) != bytes) {
    source_.fail(kShort);
  }
}

void PlyValues::skip(const PlyElement& element) {
  if (element.properties.empty()) return;
  for (std::uint64_t i = 0; i < element.count; ++i) {
    for (const PlyProperty& property : element.properties) skip(property);
  }
}

void PlyValues::check_end() {
  for (std::string_view rest = source_.peek(1); !rest.empty(); rest = source_.peek(1)) {
    if (rest.find_first_not_of(" \t\r\n") != std::string_view::npos) {
      fail("something follows the last element; correct the counts in the PLY header");
    }
    source_.consume(rest.size());
  }
}

void PlyValues::fail(const std::string& what) const {
  if (is_text()) text_.fail(what);
  source_.fail(what);
}

std::string_view PlyValues::take_word() {
  const std::string_view word = text_.next_word();
  if (word.empty()) text_.fail(kShort);
  if (!text_.terminated()) {
    text_.fail(
        "no line end behind the last value, so digits may be missing; fetch the file again, or add "
        "the line end if it is whole");
  }
  return word;
}

const char* PlyValues::peek(std::size_t size) {
  const std::string_view ready = source_.peek(size);
  if (ready.size() < size) source_.fail(kShort);
  return ready.data();
}

}  // namespace stream_recon
