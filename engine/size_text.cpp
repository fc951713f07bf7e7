#include "engine/size_text.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>

namespace stream_recon {
namespace {

constexpr std::uint64_t kMebi = std::uint64_t{1} << 20;

/// The power of 1024 that a unit's letter stands for; nothing for an unknown unit.
std::optional<int> unit_exponent(std::string_view unit) {
  if (unit.empty() || unit == "B" || unit == "b") return 0;
  static constexpr std::string_view kLetters = "KMGT";
  const char letter = unit[0] >= 'a' && unit[0] <= 'z' ? char(unit[0] - 'a' + 'A') : unit[0];
  const std::size_t at = kLetters.find(letter);
  if (at == std::string_view::npos) return std::nullopt;
  const std::string_view rest = unit.substr(1);
  const bool known = rest.empty() || rest == "B" || rest == "b" || rest == "iB";
  return known ? std::optional<int>(int(at) + 1) : std::nullopt;
}

}  // namespace

std::optional<std::uint64_t> parse_size(std::string_view text) {
  double number = 0;
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, number, std::chars_format::fixed);
  if (error != std::errc{}) return std::nullopt;
  const auto exponent = unit_exponent({stop, static_cast<std::size_t>(end - stop)});
  if (!exponent) return std::nullopt;
  const double bytes = std::ceil(std::ldexp(number, 10 * *exponent));
  if (!(bytes >= 1 && bytes <= 0x1p63)) return std::nullopt;
  return static_cast<std::uint64_t>(bytes);
}

std::string size_text(std::uint64_t bytes) {
  static constexpr const char* kUnits[] = {"bytes", "KiB", "MiB", "GiB", "TiB", "PiB", "EiB"};
  double value = static_cast<double>(bytes);
  int unit = 0;
  while (value >= 1024 && unit < 6) {
    value /= 1024;
    ++unit;
  }
  return unit == 0 ? fmt::format("{} bytes", bytes) : fmt::format("{:.1f} {}", value, kUnits[unit]);
}

std::string size_argument(std::uint64_t bytes) {
  return fmt::format("{}M", bytes / kMebi + (bytes % kMebi != 0 ? 1 : 0));
}

}  // namespace stream_recon
