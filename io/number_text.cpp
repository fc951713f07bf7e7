#include "io/number_text.h"

#include <charconv>
#include <cstdlib>
#include <system_error>

namespace stream_recon {
namespace {

double convert(const char* text, float /*type*/) {
  return std::strtof(text, nullptr);
}
double convert(const char* text, double /*type*/) {
  return std::strtod(text, nullptr);
}

template <typename T>
const char* parse(const char* begin, const char* end, double& value) {
  if (begin != end && *begin == '+') {
    ++begin;
    if (begin != end && *begin == '-') return nullptr;
  }
  T parsed{};
  const std::from_chars_result result = std::from_chars(begin, end, parsed);
  if (result.ec == std::errc::invalid_argument) return nullptr;
  // from_chars leaves the value alone out of range; the C library gives the infinity or the zero.
  value = result.ec == std::errc{} ? static_cast<double>(parsed)
                                   : convert(std::string(begin, result.ptr).c_str(), T{});
  return result.ptr;
}

template <typename T>
std::optional<double> whole(std::string_view text) {
  double value = 0;
  const char* end = text.data() + text.size();
  if (parse<T>(text.data(), end, value) != end || text.empty()) return std::nullopt;
  return value;
}

}  // namespace

const char* parse_double(const char* begin, const char* end, double& value) {
  return parse<double>(begin, end, value);
}

const char* parse_float(const char* begin, const char* end, double& value) {
  return parse<float>(begin, end, value);
}

std::optional<double> whole_double(std::string_view text) {
  return whole<double>(text);
}

std::optional<double> whole_float(std::string_view text) {
  return whole<float>(text);
}

std::optional<std::uint64_t> whole_count(std::string_view text) {
  std::uint64_t count = 0;
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, count);
  if (error != std::errc{} || stop != end) return std::nullopt;
  return count;
}

std::string quote_text(std::string_view text) {
  constexpr std::size_t kLongest = 40;
  std::string result = "\"";
  for (const char c : text.substr(0, kLongest)) {
    const auto code = static_cast<unsigned char>(c);
    result += code < 0x20 || code == 0x7f ? '?' : c;
  }
  return result + (text.size() > kLongest ? "...\"" : "\"");
}

}  // namespace stream_recon
