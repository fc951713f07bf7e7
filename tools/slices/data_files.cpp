#include "tools/slices/data_files.h"

#include <fmt/format.h>

#include <cctype>
#include <filesystem>
#include <optional>
#include <sstream>

#include "io/error.h"

namespace stream_recon {
namespace {

constexpr long kMostFiles = 1'000'000;

/// printf's %d and %05d.
struct NumberedName {
  std::string before, after;
  int width = 0;
  bool has_zeros = false;

  std::string with(long number) const {
    return before +
           (has_zeros ? fmt::format("{:0{}}", number, width)
                      : fmt::format("{:{}}", number, width)) +
           after;
  }
};

std::optional<NumberedName> numbered_name(const std::string& pattern) {
  const std::size_t percent = pattern.find('%');
  const std::size_t d = pattern.find('d', percent);
  if (percent == std::string::npos || d == std::string::npos || d - percent > 3) return {};
  const std::string digits = pattern.substr(percent + 1, d - percent - 1);
  for (const char c : digits)
    if (std::isdigit(static_cast<unsigned char>(c)) == 0) return {};
  NumberedName name{pattern.substr(0, percent), pattern.substr(d + 1)};
  name.width = digits.empty() ? 0 : std::stoi(digits);
  name.has_zeros = digits.starts_with('0');
  return name;
}

std::vector<std::string> listed_names(std::istream& rest) {
  std::vector<std::string> names;
  for (std::string line; std::getline(rest, line);)
    if (!trimmed(line).empty()) names.push_back(trimmed(line));
  return names;
}

std::vector<std::string> names_in(const std::string& header_path, const std::string& value,
                                  std::istream& rest) {
  std::istringstream words(value);
  std::string first;
  words >> first;
  if (first == "LIST") return listed_names(rest);
  long low = 0;
  long high = 0;
  long step = 1;
  const auto pattern = numbered_name(first);
  if (!pattern || !(words >> low >> high)) return {value};
  words >> step;
  std::vector<std::string> names;
  if (step == 0 || (high - low) / step < 0) return names;
  const long count = (high - low) / step + 1;
  if (count > kMostFiles)
    throw InputError(fmt::format("{}: names {} data files; check the header", header_path, count));
  for (long n = 0; n < count; ++n) names.push_back(pattern->with(low + n * step));
  return names;
}

}  // namespace

std::string trimmed(const std::string& text) {
  const char* const blanks = " \t\r";
  const std::size_t first = text.find_first_not_of(blanks);
  if (first == std::string::npos) return "";
  return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

std::vector<std::string> named_data_files(const std::string& header_path, const std::string& value,
                                          std::istream& rest) {
  std::vector<std::string> paths;
  if (value.empty()) return paths;
  const auto folder = std::filesystem::path(header_path).parent_path();
  for (const std::string& name : names_in(header_path, value, rest))
    paths.push_back((folder / name).string());
  return paths;
}

}  // namespace stream_recon
